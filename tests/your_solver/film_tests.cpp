// The film of the reader's own solver: that it is drawn, whole and small, shows a wrong motion as one, and
// says in one line why there is none.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "render/image.hpp"
#include "run_solver.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cairn;
using namespace cairn::solver_tests;

constexpr int few_pixels = 100;  // of 339,360: borders of shapes that begin at another fraction of a pixel

/// `bash lessons/run solver STAGE --film WORDS`, drawn by the program of this build.
Ended film(const fs::path& folder, int stage, const std::string& words = "") {
  return run_line("export CAIRN_SOLVER_FILM=" + in_quotes(CAIRN_SOLVER_FILM) + "; cd " +
                  in_quotes(folder.string()) + " && bash " + in_quotes(CAIRN_SOURCE_DIR "/lessons/run") +
                  " solver " + std::to_string(stage) + " --film" + words);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

/// The left half of a frame, or the right one, without the borders.
render::Image half_of(const fs::path& path, bool is_right) {
  const render::Image image = render::read_png(path);
  return render::part_of(image, is_right ? 650 : 22, 100, 606, 560);
}

int differing_halves(const fs::path& path) {
  return static_cast<int>(render::compare(half_of(path, false), half_of(path, true)).differing);
}

}  // namespace

TEST_CASE("the film of every model is whole, below 1 MB, and the same on both sides") {
  const fs::path folder = scratch_folder("film");
  for (int stage = 0; stage < 10; ++stage) {
    INFO("stage ", stage);
    write_file(folder / "my_solver.cpp", model_of(stage));
    const Ended ended = film(folder, stage);
    CHECK_MESSAGE(ended.code == 0, ended.out);
    CHECK_MESSAGE(ended.out.find("Your bodies move as the model's do") != std::string::npos, ended.out);
    CHECK_MESSAGE(ended.out.find("frame ") == std::string::npos, ended.out);  // lint finds nothing
    const std::string name = "solver0" + std::to_string(stage);
    CHECK(ended.out.find("out/" + name + "/" + name + ".apng") != std::string::npos);
    CHECK(fs::file_size(folder / "out" / name / (name + ".apng")) < 1'000'000);
    CHECK(differing_halves(folder / "out" / name / (name + "_0012.png")) < few_pixels);
  }
}

TEST_CASE("a wrong solver moves wrongly in its film, and the model does not") {
  const fs::path folder = scratch_folder("wrong_film");
  write_file(folder / "my_solver.cpp",
             replaced(model_of(0), "velocity[1] -= gravity", "velocity[1] += gravity"));
  const Ended ended = film(folder, 0, " --theme dark");
  CHECK_MESSAGE(ended.code == 0, ended.out);
  // After 1.2 s and 60 steps both paths are g t (t + dt)/2 = 7.32 m from the straight one.
  CHECK_MESSAGE(ended.out.find("a corner is up to 14.6 m away") != std::string::npos, ended.out);
  CHECK(differing_halves(folder / "out/solver00/solver00_0021.png") > 20 * few_pixels);
  write_file(folder / "my_solver.cpp",
             replaced(model_of(2), "return inverse > 0 ? 1 / inverse : 0", "return 0 / 0.0"));
  CHECK(film(folder, 2).out.find("one flies away") != std::string::npos);
  // Each push clamped: this box hops and falls, and the model's stands on both feet.
  write_file(folder / "my_solver.cpp",
             replaced(model_of(4), "std::clamp(before + correction(row, bodies), row.lower, row.upper)",
                      "before + std::clamp(correction(row, bodies), row.lower, row.upper)"));
  const Ended clamped = film(folder, 4);
  CHECK_MESSAGE(clamped.out.find(" m away") != std::string::npos, clamped.out);
}

TEST_CASE("names of the reader's are no names of the film's scenes") {
  const fs::path folder = scratch_folder("film_names");
  write_file(folder / "my_solver.cpp", model_of(9) +
                                           "struct Face {};\nstruct Touch {};\nint feet = 0, note_rod = 0;\n"
                                           "struct Motion {};\nint main() { return feet + note_rod; }\n");
  CHECK(film(folder, 9).code == 0);
}

TEST_CASE("a solver that crashes, never ends or lacks a function has no film, and one line says why") {
  const fs::path folder = scratch_folder("no_film");
  for (const auto& [deed, words] :
       {std::pair("int* volatile nowhere = nullptr; *nowhere = 1;", "a null pointer: signal 11.\n"),
        std::pair("while (true) {}", "did not end within 10 s: does one of its loops never stop?\n")}) {
    write_file(folder / "my_solver.cpp",
               replaced(model_of(0), "Body box;", std::string("Body box; ") + deed));
    const Ended ended = film(folder, 0);
    CHECK(ended.code == 1);
    CHECK_MESSAGE(ended.out.find(words) != std::string::npos, ended.out);
    CHECK(ended.out.find('\n') == ended.out.size() - 1);
  }
  write_file(folder / "my_solver.cpp", model_of(1));
  const Ended lacking = film(folder, 2);
  CHECK(lacking.code == 1);
  CHECK_MESSAGE(lacking.out.find("Stage 02 cannot use my_solver.cpp: ") != std::string::npos, lacking.out);
  CHECK_FALSE(fs::exists(folder / "out"));
}
