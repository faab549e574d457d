// What a lesson writes, what it removes, and what it never touches.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Names = List<std::string>;

/// Three frames and a row of data.
void film_three(Lesson& lesson) {
  lesson.film({word_shot("one"), word_shot("two"), word_shot("three")});
  CsvTable table = {.header = {"step", "x"}};
  table.rows.push_back({});
  table.rows.back().emplace_back(1LL);
  table.rows.back().emplace_back(0.1);
  lesson.data(table);
  lesson.fingerprint(List<double>{0.1});
}

Ran film_into(const ScratchFolder& folder, Names flags) {
  const Names all = {"--size", "small", "-o", folder.path() + "/out"};
  flags.insert(flags.begin(), all.begin(), all.end());
  return run_in_child(film_three, flags);
}

}  // namespace

TEST_CASE("a run leaves its pictures in order, their index, its rows and an account of itself") {
  const ScratchFolder folder;
  const Ran ran = film_into(folder, {});
  CHECK(ran.code == 0);
  CHECK(ran.out.find("3 pictures: " + folder.path() + "/out/index.html\n") != std::string::npos);
  CHECK(folder.names("out") == Names{"frames.json", "index.html", "l42_0001.png", "l42_0002.png",
                                     "l42_0003.png", "rows.csv", "run.json"});
  CHECK(folder.text("out/rows.csv") == "step,x\n1,0.10000000000000001\n");
  const auto index = nlohmann::json::parse(folder.text("out/frames.json"));
  CHECK(index["frames"].size() == 3);
  CHECK(index["frames"][1]["file"] == "l42_0002.png");
  CHECK(index["frames"][1]["frame"] == 2);
  CHECK(index["frames"][1]["alt"] == "The word two.");
  CHECK(index["frames"][1]["words"].back() == "two");
  const auto run = nlohmann::json::parse(folder.text("out/run.json"));
  CHECK(run["flags"]["dt"] == 0.02);
  CHECK(run["flags"]["steps"].dump() == "3");
  CHECK(run["pictures"] == 3);
}

TEST_CASE("a picture has the size that was asked for") {
  const ScratchFolder folder;
  film_into(folder, {"--frames", "2", "--size", "1000x600"});
  const render::Image image = render::read_png(folder.path() + "/out/l42_0001.png");
  CHECK(image.width == 1000);
  CHECK(image.height == 600);
}

TEST_CASE("the same run gives the same files, byte for byte") {
  const ScratchFolder first;
  const ScratchFolder second;
  film_into(first, {"--frames", "all"});
  film_into(second, {"--frames", "all"});
  for (const std::string& name : first.names("out")) {
    if (name == "run.json") continue;  // names its folder
    CHECK_MESSAGE(first.text("out/" + name) == second.text("out/" + name), name);
  }
}

TEST_CASE("pictures of an earlier run that are not written again go, and nothing else does") {
  const ScratchFolder folder;
  film_into(folder, {});
  folder.write("out/mine.txt", "mine");
  folder.write("out/l42_0009.png", "not in the index");
  const Ran ran = film_into(folder, {"--frames", "-1"});
  CHECK(ran.code == 0);
  CHECK(folder.names("out") == Names{"frames.json", "index.html", "l42_0001.png", "l42_0009.png", "mine.txt",
                                     "rows.csv", "run.json"});
  CHECK(nlohmann::json::parse(folder.text("out/frames.json"))["frames"][0]["frame"] == 3);
}

TEST_CASE("an index that was tampered with does not remove files outside the folder or of other names") {
  const ScratchFolder folder;
  folder.write("precious.png", "precious");
  folder.write("out/other.png", "other");
  folder.write(
      "out/frames.json",
      R"({"lesson": 42, "frames": [{"file": "../precious.png"}, {"file": "l42_/../../precious.png"}, {"file": "other.png"},
                              {"file": 5}, 7]})");
  CHECK(film_into(folder, {}).code == 0);
  CHECK(folder.text("precious.png") == "precious");
  CHECK(folder.text("out/other.png") == "other");
}

TEST_CASE("a frames.json that no lesson wrote is left alone, and nothing is put beside it") {
  const ScratchFolder folder;
  for (const char* index : {"{ broken", "[]", R"({"frames": []})", R"({"film": "stack", "frames": 7})"}) {
    folder.write("out/frames.json", index);
    const Ran ran = film_into(folder, {});
    CHECK(ran.code == 3);
    CHECK(ran.err.find("out/frames.json: there is one that no lesson wrote") != std::string::npos);
    CHECK(folder.text("out/frames.json") == index);
    CHECK(folder.names("out") == Names{"frames.json"});
  }
}

TEST_CASE("a dry run, a check and a run without frames write nothing") {
  const ScratchFolder folder;
  for (const char* flag : {"--dry-run", "--check", "--frames=none"}) {
    CHECK_MESSAGE(film_into(folder, {flag}).code == 0, std::string(flag));
    CHECK_MESSAGE(folder.names().empty(), std::string(flag));
  }
  CHECK(film_into(folder, {"--dry-run", "--csv", folder.path() + "/rows.csv"}).code == 0);
  CHECK(folder.names().empty());
}

TEST_CASE("data on stdout is pure, and the narration goes to stderr") {
  const ScratchFolder folder;
  const Ran csv = film_into(folder, {"--frames", "none", "--csv", "-"});
  CHECK(csv.out == "step,x\n1,0.10000000000000001\n");
  CHECK(csv.err.find("Lesson 42") != std::string::npos);
  const Ran json = film_into(folder, {"--frames", "none", "--json", "-"});
  const auto rows = nlohmann::json::parse(json.out);
  CHECK(rows[0]["step"] == 1);
  CHECK(rows[0]["x"] == 0.1);
  CHECK(folder.names().empty());
}

TEST_CASE("a folder that cannot be made gives exit code three, names itself, and leaves nothing") {
  const ScratchFolder folder;
  folder.write("file", "in the way");
  const Ran ran = run_in_child(film_three, {"--size", "small", "-o", folder.path() + "/file/out"});
  CHECK(ran.code == 3);
  CHECK(ran.err.find(folder.path() + "/file/out") != std::string::npos);
  CHECK(ran.err.find("--frames none") != std::string::npos);
  CHECK(folder.names() == Names{"file"});
  CHECK(folder.text("file") == "in the way");
  CHECK(film_into(folder, {"--frames", "none", "--csv", "/dev/full"}).code == 3);
  CHECK(film_into(folder, {"--frames", "none", "--csv", folder.path() + "/file/rows.csv"}).code == 3);
}

TEST_CASE("when a picture cannot be written, those of the same run are removed") {
  const ScratchFolder folder;
  folder.write("out/l42_0003.png/in_the_way", "");  // a folder of the picture's name
  CHECK(film_into(folder, {}).code == 3);
  CHECK(folder.names("out") == Names{"l42_0003.png"});
}

TEST_CASE("a frame that the sequence does not have is a mistake of the command line") {
  const ScratchFolder folder;
  const Ran ran = film_into(folder, {"--frames", "9"});
  CHECK(ran.code == 2);
  CHECK(ran.err.find("frames 1 to 3") != std::string::npos);
  CHECK(folder.names().empty());
}

TEST_CASE("text upon text is found in every frame and fails the lesson") {
  const ScratchFolder folder;
  const auto lesson = [](Lesson& run) {
    Shot shot = word_shot("one");
    const auto draw = shot.draw;
    shot.draw = [draw](render::Page& page) {
      draw(page);
      draw(page);
    };
    run.film({shot});
  };
  const Ran ran = run_in_child(lesson, {"-v", "--size", "small", "-o", folder.path() + "/out"});
  CHECK(ran.code == 1);
  CHECK(ran.out.find("CHECK  layout") != std::string::npos);
  CHECK(ran.err.find("frame 1: ") != std::string::npos);
}

TEST_CASE("a shot without alt text, too many key frames and a second film are mistakes of the lesson") {
  const ScratchFolder folder;
  const auto code = [&folder](const std::function<void(Lesson&)>& lesson) {
    return run_in_child(lesson, {"--size", "small", "-o", folder.path() + "/out"}).code;
  };
  Shot mute = word_shot("one");
  mute.alt.clear();
  CHECK(code([&mute](Lesson& run) { run.film({mute}); }) == 1);
  CHECK(code([](Lesson& run) { run.film(List<Shot>(13, word_shot("one"))); }) == 1);
  CHECK(code([](Lesson& run) {
          run.film({});
          run.film({});
        }) == 1);
  CHECK(folder.names().empty());
}
