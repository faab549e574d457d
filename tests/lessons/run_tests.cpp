// A whole lesson: exit codes, streams, claims.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int code_of(const std::function<void(Lesson&)>& lesson, const List<std::string>& flags = {}) {
  return run_in_child(lesson, flags).code;
}

}  // namespace

TEST_CASE("a lesson whose claims all hold returns zero, one that does not hold returns one") {
  CHECK(code_of([](Lesson& lesson) { lesson.check_small("small", 1e-13, 1e-12); }) == 0);
  CHECK(code_of([](Lesson& lesson) { lesson.check_small("small", -1e-11, 1e-12); }) == 1);
  CHECK(code_of([](Lesson& lesson) { lesson.check_equal("equal", 2.05, 2, 0.1); }) == 0);
  CHECK(code_of([](Lesson& lesson) { lesson.check_equal("equal", 2.15, 2, 0.1); }) == 1);
  CHECK(code_of([](Lesson& lesson) { lesson.check_that("that", true, "yes"); }) == 0);
  CHECK(code_of([](Lesson& lesson) { lesson.check_that("that", false, "no"); }) == 1);
}

TEST_CASE("a claim about a value that is not a number fails") {
  CHECK(code_of([](Lesson& lesson) { lesson.check_small("small", std::nan(""), 1); }) == 1);
  CHECK(code_of([](Lesson& lesson) { lesson.check_equal("equal", std::nan(""), 1, 1e300); }) == 1);
  CHECK(code_of([](Lesson& lesson) { lesson.check_equal("equal", INFINITY, INFINITY, 1); }) == 1);
}

TEST_CASE("one failed claim among many decides, and is printed with what was demanded") {
  const Ran ran = run_in_child(
      [](Lesson& lesson) {
        lesson.check_that("first", true, "");
        lesson.check_small("second", 0.5, 0.25);
        lesson.check_that("third", true, "");
      },
      {"-q"});
  CHECK(ran.code == 1);
  CHECK(says(ran.out, "0.5000    FAILED\n"));
  CHECK(says(ran.out, "must be at most 0.25, is 0.5"));
  CHECK(ran.out.rfind("CHECK  first ...", 0) == 0);
}

TEST_CASE("each way to fail has its exit code") {
  CHECK(code_of([](Lesson&) { throw Diverged("body 3"); }) == 4);
  CHECK(code_of([](Lesson&) { throw Skipped("without Box2D"); }) == 77);
  CHECK(code_of([](Lesson&) { throw render::RenderError("no context"); }) == 3);
  CHECK(code_of([](Lesson&) { throw render::WriteError("disk full"); }) == 3);
  CHECK(code_of([](Lesson&) { throw std::invalid_argument("World: dt must be positive s, got 0"); }) == 2);
  CHECK(code_of([](Lesson&) { throw std::logic_error("a mistake"); }) == 1);
  CHECK(code_of([](Lesson&) {}, {"--dt", "5"}) == 2);
  CHECK(code_of([](Lesson& lesson) { lesson.real("mu"); }) == 1);
}

TEST_CASE("when nothing can be drawn the message names the flag that helps") {
  const Ran ran = run_in_child([](Lesson&) { throw render::RenderError("no context"); }, {});
  CHECK(says(ran.err, "lesson42: no context"));
  CHECK(says(ran.err, "--frames none"));
}

TEST_CASE("parameters reach the lesson, fractions to the last bit") {
  const auto lesson = [](Lesson& run) {
    run.check_equal("dt", run.real("dt"), 1.0 / 60, 0);
    run.check_equal("steps", run.whole("steps"), 7, 0);
    run.check_that("precision", run.choice("precision") == "float", run.choice("precision"));
  };
  CHECK(code_of(lesson, {"--dt", "1/60", "--steps=7", "--precision", "float"}) == 0);
  CHECK(code_of(lesson) == 1);
}

TEST_CASE(
    "a run prints title, idea, equations, question, claims, command line and next lesson in this order") {
  const Ran ran = run_in_child(
      [](Lesson& lesson) {
        lesson.predict();
        lesson.print("a step");
        lesson.detail("a detail");
        lesson.answer({42}, 0, "By counting.");
        lesson.check_that("it is", true, "42");
        lesson.fingerprint(List<double>{42});
      },
      {"--dt", "1/60", "--checks"});
  std::size_t at = 0;
  for (const char* part :
       {"Lesson 42  Made up ", "paper 1, eq (1)", "Idea: A lesson", "λ = 1/60", "PREDICT  What is six",
        "a step", "ANSWER   42.00. By counting.", "CHECK  it is ..", "42        ok\n",
        "Again: bash lessons/run 42 --dt 0.016666666666666666 --steps 3 --precision double     state ",
        "Next:  lesson43_none"}) {
    const std::size_t found = ran.out.find(part, at);
    CHECK_MESSAGE(found != std::string::npos, std::string(part));
    if (found != std::string::npos) at = found;
  }
  CHECK_FALSE(says(ran.out, "a detail"));
  CHECK_FALSE(says(ran.out, "\x1b"));  // no colour in a file
  CHECK(ran.err.empty());
}

TEST_CASE("quiet leaves the claims only, verbose adds details, plain is ASCII") {
  const auto lesson = [](Lesson& run) {
    run.print("λ = 1");
    run.detail("a detail");
    run.check_that("λ ≥ 0", true, "");
  };
  const Ran quiet = run_in_child(lesson, {"-q"});
  CHECK(quiet.out.rfind("CHECK  λ ≥ 0 ", 0) == 0);
  CHECK(std::count(quiet.out.begin(), quiet.out.end(), '\n') == 1);
  CHECK(says(run_in_child(lesson, {"-v"}).out, "a detail"));
  const std::string plain = run_in_child(lesson, {"--plain", "--checks"}).out;
  CHECK(says(plain, "CHECK  lambda >= 0 "));
  CHECK(std::all_of(plain.begin(), plain.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
}

TEST_CASE("colours come when they are asked for, and never with --plain") {
  const auto lesson = [](Lesson& run) { run.check_that("fine", true, ""); };
  CHECK(says(run_in_child(lesson, {"--color", "always", "--checks"}).out, "\x1b[32mok\x1b[0m"));
  CHECK_FALSE(says(run_in_child(lesson, {"--color", "always", "--plain"}).out, "\x1b"));
}

TEST_CASE("an answer on the command line is judged, and a wrong one gives exit code one") {
  const auto lesson = [](Lesson& run) {
    run.predict();
    run.answer({42, -1}, 0.5, "By counting.");
  };
  const Ran right = run_in_child(lesson, {"--answer", "42.4,-1"});
  CHECK(right.code == 0);
  CHECK(says(right.out, "RIGHT"));
  const Ran wrong = run_in_child(lesson, {"--answer", "42.6,-1"});
  CHECK(wrong.code == 1);
  CHECK(says(wrong.out, "NOT YET  you said 42.60, −1.000; it is 42.00, −1.000"));
  const Ran fewer = run_in_child(lesson, {"--answer", "42"}),
            more = run_in_child(lesson, {"--answer", "42,0,-1"});
  CHECK(fewer.code == 1);
  CHECK(says(fewer.out, "NOT YET  you said 1 number, and the question asks for 2: a comma stands between"));
  CHECK(more.code == 1);
  CHECK(says(more.out, "NOT YET  you said 3 numbers, and the question asks for 2"));
  // What is printed alike is right, however small the tolerance.
  const auto third = [](Lesson& run) { run.answer({1 / 3.0}, 0, "By division."); };
  CHECK(code_of(third, {"--answer", "0.3333"}) == 0);
  CHECK(code_of(third, {"--answer", "0.333"}) == 1);
  CHECK(code_of(lesson, {"--predict"}) == 0);  // no terminal, so no prompt
}

TEST_CASE("a wrong guess that is known is told why it is wrong, and any other what is right") {
  const auto lesson = [](Lesson& run) { run.answer({42}, 0.5, "By counting."); };
  const Ran sum = run_in_child(lesson, {"--answer", "13.2"}),
            other = run_in_child(lesson, {"--answer", "15"});
  CHECK(sum.code == 1);
  CHECK(says(sum.out, "NOT YET  you said 13.20. That is the sum. It is 42.00. By counting."));
  CHECK(says(other.out, "NOT YET  you said 15.00; it is 42.00. By counting."));
}

TEST_CASE("with --predict, nothing of idea and equations stands before the question") {
  const Ran ran = run_in_child([](Lesson& run) { run.predict(); }, {"--predict"});
  const std::size_t question = ran.out.find("PREDICT");
  CHECK(question != std::string::npos);
  CHECK(ran.out.find("Idea: A lesson") > question);
  CHECK(ran.out.find("λ = 1/60") > question);
  CHECK(says(ran.out, "λ = 1/60"));
}

TEST_CASE("a question about other values than those of the run is not asked, and not answered") {
  const auto lesson = [](Lesson& run) {
    run.predict();
    run.answer({42}, 0.5, "By counting.");
  };
  const Ran changed = run_in_child(lesson, {"--steps", "7"}),
            chosen = run_in_child(lesson, {"--precision", "float"});
  for (const Ran& ran : {changed, chosen}) {
    CHECK_FALSE(says(ran.out, "PREDICT"));
    CHECK_FALSE(says(ran.out, "ANSWER"));
    CHECK(says(ran.out, "λ = 1/60"));
  }
  CHECK(says(run_in_child(lesson, {"--dt", "0.01"}).out, "PREDICT"));  // the question is not about dt
  CHECK(run_in_child(lesson, {"--steps", "7", "--answer", "41"}).code == 1);
}

TEST_CASE("the state of a run can be demanded of the next") {
  const auto lesson = [](Lesson& run) { run.fingerprint(List<double>{}); };
  CHECK(code_of(lesson, {"--expect", "cbf29ce484222325"}) == 0);  // FNV-1a of nothing: its offset basis
  CHECK(code_of(lesson, {"--expect", "cbf29ce484222326"}) == 1);
  CHECK(code_of([](Lesson&) {}, {"--expect", "cbf29ce484222325"}) == 1);
}

TEST_CASE("help, version, about, hints and parameters are told without a run") {
  const auto lesson = [](Lesson&) { throw std::logic_error("ran"); };
  for (const char* flag : {"--help", "-h", "--version", "--about", "--list-params", "--hint"}) {
    const Ran ran = run_in_child(lesson, {flag});
    CHECK_MESSAGE(ran.code == 0, std::string(flag));
    CHECK_MESSAGE(!ran.out.empty(), std::string(flag));
  }
  CHECK(run_in_child(lesson, {"--hint", "2"}).out == "It is 42.\n");
  CHECK(says(run_in_child(lesson, {"--help"}).out, "--dt X"));
  CHECK_FALSE(says(run_in_child(lesson, {"--help"}).out, "--bodies"));
  CHECK(says(run_in_child(lesson, {"--list-params"}).out, "--dt\t0.02\t0.001\t0.1\ts\ttime step\n"));
}
