// Lesson 08. Warm start: the first part of Algorithm 1, which lesson 03 left out.
// A tower that stood a moment ago still stands, and its contacts push as hard as before. So the sweeps of a
// step begin with the impulses of the last one, and each impulse has to find its own row again: it is kept
// under the row's key. Two towers show what that is worth: one begins every step from zero, one from its own
// impulses. In two more runs a ball bounces beside the tower, and impulses are found by key or by number.
#include "lesson.hpp"

#include "lessons/kit/words.hpp"

namespace {

using namespace cairn;
using namespace cairn::warm;

// [guess]
/// Last step's impulse of the row of that name; 0 if it was not there.
double remembered(const Memory& last, const RowKey& key) {
  for (const auto& entry : last)
    if (entry.first == key) return entry.second;
  return 0;
}

/// Lines 2-6 of Algorithm 1: what the rows of a step begin with.
PerRow<double> first_guess(const VelocityProblem<double>& problem, Start start, const Memory& last) {
  PerRow<double> guess(problem.row_count(), 0.0);  // cold: from zero
  for (int i = 0; i < guess.size(); ++i) {
    if (start == Start::warm) guess[i] = remembered(last, problem.rows[i].key);
    if (start == Start::by_number && i < last.size()) guess[i] = last[i].second;  // a mistake
  }
  return guess;
}
// [/guess]

/// Sequential impulses that remember. The world's own warm start, which does the same, is off.
class Remembering final : public Solver<double> {
 public:
  Remembering(int sweeps, Start start) : sweeps_({.iterations = sweeps}), start_(start) {}
  std::string name() const override { return "SI with a first guess"; }

  // [solve]
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer = nullptr) override {
    problem.impulse = first_guess(problem, start_, last_);
    const SolveReport report = sweeps_.solve(problem, observer);  // (21): the guess acts; then the sweeps

    last_.clear();
    for (int i = 0; i < problem.row_count(); ++i) last_.emplace_back(problem.rows[i].key, problem.impulse[i]);
    return report;
  }
  // [/solve]

 private:
  SequentialImpulse<double> sweeps_;
  Start start_;
  Memory last_;
};

WarmStart run_all(const StartSettings& settings) {
  const int sweeps = settings.sweeps;
  Remembering cold(sweeps, Start::cold), warm(sweeps, Start::warm);
  Remembering with_guest(sweeps, Start::warm), numbered(sweeps, Start::by_number);
  WarmStart all{.settings = settings};
  all.cold = follow_tower(settings, cold, "cold");
  all.warm = follow_tower(settings, warm, "warm");
  StartSettings longer = settings;
  longer.steps = question_steps;
  Remembering many(many_sweeps, Start::cold);
  all.many_cold = follow_tower(longer, many, fmt::format("cold, {} sweeps", many_sweeps));
  Remembering one(1, Start::warm);
  all.one_warm = follow_tower(longer, one, "warm, 1 sweep");
  all.guest = follow_guest(settings, with_guest, numbered);
  for (const int boxes : {3, 5, 10, 20}) all.sweeps.push_back(sweep_cold(boxes, settings.dt));
  all.library = run_library(settings);
  return all;
}

void run(Lesson& lesson) {
  const WarmStart all = run_all({.boxes = lesson.whole("boxes"),
                                 .sweeps = lesson.whole("sweeps"),
                                 .steps = lesson.whole("steps"),
                                 .dt = lesson.real("dt")});
  tell_scene(lesson, all.settings);
  constexpr int page_width = 104;  // columns
  if (question_of(all) == card().question) {
    lesson.predict();
  } else {
    lesson.print(wrapped("QUESTION " + question_of(all), page_width, 9));
  }
  tell_loads(lesson, all);
  tell_sweeps(lesson, all);
  tell_price(lesson, all);
  tell_order(lesson, all);
  lesson.answer(
      {-risen(all.one_warm, question_steps)}, 20,
      "The tower falls until its impulses have grown. But they stay, so the sweeps of all steps work "
      "on one answer, and then it stands; begun from zero, it sinks on for ever.");
  check_claims(lesson, all);
  lesson.film(start_shots(all));
  lesson.data(table_of(all));
  lesson.fingerprint(all.warm.frames.back());
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
