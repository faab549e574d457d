// The way back: moments that were kept, and what leads from them to a step; and refusals that change nothing.
#include <fmt/format.h>

#include <iterator>
#include <stdexcept>
#include <utility>

#include <cairn/math/check.hpp>
#include "lessons/playground/playground.hpp"
#include <cairn/scenes/scene_file.hpp>

namespace cairn::playground {

namespace {

constexpr int most_checkpoints = 40;

}  // namespace

/// Does it, and looks at the solve that comes then. Where either is refused, all is as before.
void Playground::all_or_nothing(const std::function<void()>& act) {
  Benches before = copies(benches_);
  const std::optional<int> cursor = cursor_;
  const bool had_diverged = has_diverged_;
  List<SolveLook> looks = std::move(looks_);
  std::optional<PerRow<double>> ends = std::move(ends_);
  try {
    act();
    forget_solve();
    look(0);
  } catch (...) {
    benches_ = std::move(before);
    has_diverged_ = had_diverged;
    cursor_ = cursor;
    looks_ = std::move(looks);
    ends_ = std::move(ends);
    const int steps = benches_[0]->steps();
    while (!checkpoints_.empty() && checkpoints_.back().benches[0]->steps() > steps) checkpoints_.pop_back();
    history_.keep(benches_[0]->snapshot());
    throw;
  }
}

void Playground::back() {
  if (cursor_) return visit_row(0);
  const int target = benches_[0]->steps() - 1;
  if (steps_back() == 0) throw std::invalid_argument("There is no step before this one to go back to.");
  stay_here();
  const auto from = kept_before(target);
  return_to(*from, replayed(*from, benches_[0]->hand_inputs(), target));
  checkpoints_.erase(std::next(from), checkpoints_.end());
  words_ = step_words();
}

/// The last moment that is kept up to that step.
std::deque<Playground::Moment>::iterator Playground::kept_before(int step) {
  auto from = std::prev(checkpoints_.end());
  while (from->benches[0]->steps() > step) --from;
  return from;
}

/// The worlds of the moment at a later step, with what the hand did on the way.
Playground::Benches Playground::replayed(const Moment& from, const List<HandInput>& inputs,
                                         int target) const {
  Benches benches = copies(from.benches);
  for (const auto& bench : benches) {
    int next = bench->hand_inputs().size();
    while (bench->steps() < target) {
      for (; next < inputs.size() && inputs[next].step == bench->steps(); ++next) bench->repeat(inputs[next]);
      in_time([&] { bench->step(); });
    }
    if (bench->hand()) bench->repeat({.kind = HandInput::Kind::let_go});
  }
  return benches;
}

void Playground::visit(int step) {
  const int first = benches_[0]->steps() - steps_back(), last = last_step();
  require(step >= first && step <= last, "visit", "step", fmt::format("from {} to {}", first, last), step);
  if (step == benches_[0]->steps() && !cursor_) return;
  std::optional<Moment> here;
  if (!end_) here = now();
  const Moment& end = end_ ? *end_ : *here;
  const Moment& from = step == last ? end : *kept_before(step);
  const bool has_end_diverged = end.has_diverged;
  visited_changes_ = from.changes;
  take_over(from, replayed(from, end.benches[0]->hand_inputs(), step));
  has_diverged_ = step == last && has_end_diverged;
  history_.show(step);
  if (here) end_ = std::move(here);
  if (step == last) end_.reset();
  words_ = step_words();
}

int Playground::last_step() const { return (end_ ? end_->benches : benches_)[0]->steps(); }

/// What came after the step that is visited is forgotten.
void Playground::stay_here() {
  if (!end_) return;
  end_.reset();
  const int step = benches_[0]->steps();
  while (checkpoints_.size() > 1 && checkpoints_.back().benches[0]->steps() > step) checkpoints_.pop_back();
  while (changes_.size() > visited_changes_) changes_.pop_back();
  history_.keep(benches_[0]->snapshot());
}

int Playground::steps_back() const {
  return checkpoints_.empty() ? 0 : benches_[0]->steps() - checkpoints_.front().benches[0]->steps();
}

Playground::Benches Playground::copies(const Benches& benches) {
  Benches copies;
  for (const auto& bench : benches) copies.push_back(bench->copy());
  return copies;
}

Playground::Moment Playground::now() const {
  return {copies(benches_), text_, names_, controls_, changes_.size(), is_changed_, has_diverged_};
}

void Playground::return_to(const Moment& moment, Benches benches) {
  const int changes = moment.changes;
  take_over(moment, std::move(benches));
  history_.keep(benches_[0]->snapshot());
  while (changes_.size() > changes) changes_.pop_back();  // the moment may go with them
}

/// With these worlds in place of those of the moment.
void Playground::take_over(const Moment& moment, Benches benches) {
  List<SolveLook> looks = looks_of(benches);
  if (moment.text != text_) {
    const SceneEntry entry = read_scene_text(moment.text, file_);
    start_ = entry.make();
    entry_ = entry;
    lit_row_ = -1;
    prediction_.reset();
  }
  benches_ = std::move(benches);
  text_ = moment.text;
  names_ = moment.names;
  controls_ = moment.controls;
  is_changed_ = moment.is_changed;
  has_diverged_ = false;
  forget_solve();
  looks_ = std::move(looks);
}

/// The way back begins here, or leads through here: one moment a step, the last of it.
void Playground::keep_now() {
  const int step = benches_[0]->steps();
  const auto step_of = [](const Moment& moment) { return moment.benches[0]->steps(); };
  if (!checkpoints_.empty() && step_of(checkpoints_.back()) == step) checkpoints_.pop_back();
  checkpoints_.push_back(now());
  while (checkpoints_.size() > 1 && step_of(checkpoints_[1]) <= step - most_steps_back)
    checkpoints_.pop_front();
  if (checkpoints_.size() > most_checkpoints) checkpoints_.pop_front();
  since_checkpoint_ = 0;
}

}  // namespace cairn::playground
