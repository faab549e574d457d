// The command line of a lesson: what is understood, and what is said about what is not.
#include <doctest/doctest.h>

#include <string>

#include "lessons/kit/arguments.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;

namespace {

LessonInfo lesson_with_flags() {
  LessonInfo info = {.number = 6, .name = "made_up", .title = "Made up"};
  info.hints = {"vague", "plain"};
  info.parameters.push_back(
      {.flag = "dt", .standard = 0.02, .min = 0.001, .max = 0.1, .unit = "s", .what = "time step"});
  info.parameters.push_back({.flag = "bodies",
                             .standard = 3,
                             .min = 1,
                             .max = 20,
                             .what = "boxes",
                             .kind = Parameter::Kind::whole});
  info.choices.push_back({.flag = "precision", .values = {"double", "float"}, .what = "number type"});
  return info;
}

Options options_from(List<const char*> words) {
  words.insert(words.begin(), "lesson06_made_up");
  return read_arguments(lesson_with_flags(), words.size(), words.data());
}

/// What is said about the words; "" when they are accepted.
std::string complaint_about(const List<const char*>& words) {
  try {
    options_from(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("without flags a lesson has its standard values") {
  const Options options = options_from({});
  CHECK(options.numbers.at("dt") == 0.02);
  CHECK(options.numbers.at("bodies") == 3);
  CHECK(options.choices.at("precision") == "double");
  CHECK(options.out == std::filesystem::path("out/lesson06"));
  CHECK(options.frames.kind == FrameChoice::Kind::key);
  CHECK(options.width == 1280);
  CHECK(options.request == Options::Request::run);
}

TEST_CASE("long flags take their value after a blank or after an equals sign, the last one counts") {
  CHECK(options_from({"--dt", "1/60"}).numbers.at("dt") == 1.0 / 60);
  CHECK(options_from({"--dt=1/60"}).numbers.at("dt") == 1.0 / 60);
  CHECK(options_from({"--bodies", "4", "--bodies=5"}).numbers.at("bodies") == 5);
  CHECK(options_from({"--precision", "float"}).choices.at("precision") == "float");
}

TEST_CASE("negative frame numbers are values, not flags") {
  CHECK(options_from({"--frames", "-1"}).frames.first == -1);
  CHECK(options_from({"--frames=-3:-1"}).frames.first == -3);
  CHECK(options_from({"--answer", "-0.1,2"}).answer.value() == List<double>{-0.1, 2});
}

TEST_CASE("a value out of range is refused with its flag, meaning, range, unit and value on one line") {
  CHECK(complaint_about({"--dt", "5"}) ==
        "lesson06: --dt (time step) must be a number from 0.001 to 0.1 s, got 5");
  CHECK(complaint_about({"--bodies", "2.5"}) ==
        "lesson06: --bodies (boxes) must be a whole number from 1 to 20, got 2.5");
  CHECK(complaint_about({"--precision", "quad"}) ==
        "lesson06: --precision must be double or float, got quad");
}

TEST_CASE("a value that is no number is refused") {
  for (const char* text : {"nan", "inf", "-inf", "abc", "", "1/0", "0.02s"}) {
    CHECK_MESSAGE(mentions(complaint_about({"--dt", text}), "--dt (time step) must be a number"),
                  std::string(text));
  }
  CHECK(mentions(complaint_about({"--dt"}), "--dt needs a value"));
}

TEST_CASE("a flag of other lessons is told from a flag of none, and a near miss is corrected") {
  CHECK(complaint_about({"--mu", "0.5"}) ==
        "lesson06 does not use --mu; it uses: --dt, --bodies, --precision");
  CHECK(complaint_about({"--boddies", "4"}) == "lesson06: unknown flag --boddies; did you mean --bodies?");
  CHECK(complaint_about({"--boddies=4"}) == "lesson06: unknown flag --boddies; did you mean --bodies?");
  CHECK(complaint_about({"--fraems", "all"}) == "lesson06: unknown flag --fraems; did you mean --frames?");
  CHECK_FALSE(mentions(complaint_about({"--quaternion"}), "did you mean"));
  CHECK(mentions(complaint_about({"--quaternion"}), "unknown flag --quaternion"));
  CHECK(mentions(complaint_about({"seven"}), "unexpected word \"seven\""));
}

TEST_CASE("picture flags are checked before anything runs") {
  const Options options =
      options_from({"--size", "1000x600", "--theme", "dark", "--palette=gray", "-o", "here"});
  CHECK(options.width == 1000);
  CHECK(options.height == 600);
  CHECK(options.theme == Options::Theme::dark);
  CHECK(options.palette == Options::Palette::gray);
  CHECK(options.out == std::filesystem::path("here"));
  CHECK(options_from({"--size", "small"}).height == 540);
  for (const char* size :
       {"big", "1000", "1000x", "x600", "640x360", "1000x600x2", "1e9x720", "1000.5x600"}) {
    CHECK_MESSAGE(mentions(complaint_about({"--size", size}), "--size must be"), std::string(size));
  }
  CHECK(mentions(complaint_about({"--frames", "some"}), "--frames must be"));
  CHECK(mentions(complaint_about({"--theme", "sepia"}), "--theme must be light or dark, got sepia"));
  CHECK(mentions(complaint_about({"--out="}), "--out"));
}

TEST_CASE("a path that begins with a dash was meant as a flag") {
  CHECK(
      complaint_about({"--out", "--check"}) ==
      "lesson06: --out must name a folder, got --check; a path that begins with a dash is written ./--check");
  CHECK(mentions(complaint_about({"--csv", "--json"}), "--csv must name a file or be -, got --json"));
  CHECK(mentions(complaint_about({"--json=-x"}), "--json must name a file or be -, got -x"));
  CHECK(options_from({"--out", "./-x"}).out == std::filesystem::path("./-x"));
}

TEST_CASE("a dry run and a check draw nothing") {
  CHECK(options_from({"--dry-run", "--frames", "all"}).frames.kind == FrameChoice::Kind::none);
  CHECK(options_from({"--check"}).frames.kind == FrameChoice::Kind::none);
}

TEST_CASE("data on stdout sends the narration to stderr, and only one table fits") {
  CHECK(options_from({"--csv", "-"}).console.narrates_on_stderr);
  CHECK_FALSE(options_from({"--csv", "rows.csv"}).console.narrates_on_stderr);
  CHECK(mentions(complaint_about({"--csv", "-", "--json", "-"}), "stdout"));
}

TEST_CASE("hints are counted, and a hint without a number is the first") {
  CHECK(options_from({"--hint"}).hint == 1);
  CHECK(options_from({"--hint", "2"}).hint == 2);
  CHECK(options_from({"--hint", "2"}).request == Options::Request::hint);
  CHECK(complaint_about({"--hint", "3"}) == "lesson06: --hint must be a whole number from 1 to 2, got 3");
}

TEST_CASE("an expected state has sixteen hexadecimal digits") {
  CHECK(options_from({"--expect", "cbf29ce484222325"}).expect == "cbf29ce484222325");
  CHECK(mentions(complaint_about({"--expect", "9f0c"}), "16 hexadecimal digits"));
}

TEST_CASE("a lesson with two flags of one name is a mistake of the lesson") {
  LessonInfo info = lesson_with_flags();
  info.choices.push_back({.flag = "size", .values = {"a"}});
  const char* words[] = {"lesson06_made_up"};
  CHECK_THROWS_AS(read_arguments(info, 1, words), std::logic_error);
}
