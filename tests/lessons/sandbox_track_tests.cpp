// cairn run --track: a table and a chart of quantities by name.
#include <fstream>
#include <sstream>

#include "sandbox_program.hpp"
#include "scratch_folder.hpp"
#include <cairn/measure/csv.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

CsvTable table_in(const std::string& text) {
  std::istringstream in(text);
  return read_csv(in, "stdout");
}

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a tracked run prints steps, times and the quantities asked for, every so many steps") {
  const Ran ran = run_cairn({"run", "stack", "--seconds", "1", "--every", "25", "--csv", "-", "--quiet",
                             "--track", "ground:stack.1.normal,stack.10.y,energy"});
  CHECK(ran.code == 0);
  const CsvTable table = table_in(ran.out);
  CHECK(table.header ==
        List<std::string>{"step", "time_s", "ground:stack.1.normal_N", "stack.10.y_m", "energy_J"});
  REQUIRE(table.rows.size() == 4);  // 0, 25, 50, 60
  CHECK(std::get<long long>(table.rows[3][0]) == 60);
  // Ten boxes of 1 kg, which hardly move: less than the share by which a solve may end early.
  CHECK(std::get<double>(table.rows[3][2]) == doctest::Approx(100).epsilon(1e-3));
}

TEST_CASE("impulses in the table of a run are those of whole steps, however many substeps these have") {
  for (const char* const substeps : {"1", "4", "16"}) {
    const Ran ran = run_cairn({"run", "stack", "--seconds", "1", "--substeps", substeps, "--solver", "newton",
                               "--csv", "-", "--quiet"});
    const CsvTable table = table_in(ran.out);
    int column = 0;
    while (table.header.at(column) != "normal_impulse_Ns") ++column;
    // Between ground and boxes 100, 90, ... 10 N for a 60th of a second.
    CHECK(std::get<double>(table.rows.back()[column]) == doctest::Approx(550 / 60.0).epsilon(1e-3));
  }
}

TEST_CASE("a chart of tracks is a picture or a drawing") {
  const ScratchFolder folder;
  const std::string png = folder.path() + "/run.png", svg = folder.path() + "/run.svg";
  const auto drawn = [](const std::string& path) {
    return run_cairn(
        {"run", "chain-bob", "--seconds", "1", "--track", "chain.bob.y,*.1.force", "--plot", path});
  };
  CHECK(drawn(png).code == 0);
  CHECK(drawn(svg).code == 0);
  CHECK(file_text(png).substr(1, 3) == "PNG");
  CHECK(text_has(file_text(svg), "<svg"));
}

TEST_CASE("a track that says nothing, or goes nowhere, is refused before a step is done") {
  const List<std::pair<List<std::string>, std::string>> cases = {
      {{"--track", "stack.1.z", "--csv", "-"}, "track must be a known quantity (stack.1.x?), got stack.1.z"},
      {{"--track", "stack.1.y"}, "--track needs --csv or --plot"},
      {{"--plot", "run.png"}, "--plot needs --track"},
      {{"--track", "energy", "--plot", "run.pdf"},
       "--plot must be a name that ends in .png or .svg, got run.pdf"},
      {{"--every", "2", "--csv", "-"}, "--every is of the rows of --csv"},
      {{"--track", "energy", "--csv", "-", "--every", "0"}, "--every must be"}};
  for (const auto& each : cases) {
    List<std::string> words = {"run", "stack"};
    for (const std::string& word : each.first) words.push_back(word);
    const Ran ran = run_cairn(words);
    CAPTURE(ran.err);
    CHECK(ran.code == 2);
    CHECK(text_has(ran.err, each.second));
    CHECK(ran.out.empty());
  }
}
