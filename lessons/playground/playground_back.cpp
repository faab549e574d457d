// The way back: moments that were kept, and what leads from them to a step; and refusals that change nothing.
#include <iterator>
#include <stdexcept>
#include <utility>

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
  if (cursor_) {
    cursor_.reset();
    lit_row_ = -1;
    forget_look();
    words_ = "Before the step.";
    return;
  }
  const int target = benches_[0]->steps() - 1;
  if (steps_back() == 0) throw std::invalid_argument("There is no step before this one to go back to.");
  auto from = std::prev(checkpoints_.end());
  while (from->benches[0]->steps() > target) --from;
  const List<HandInput> inputs = benches_[0]->hand_inputs();
  Benches benches = copies(from->benches);
  for (const auto& bench : benches) {
    int next = bench->hand_inputs().size();
    while (bench->steps() < target) {
      for (; next < inputs.size() && inputs[next].step == bench->steps(); ++next) bench->repeat(inputs[next]);
      in_time([&] { bench->step(); });
    }
    if (bench->hand()) bench->repeat({.kind = HandInput::Kind::let_go});
  }
  return_to(*from, std::move(benches));
  checkpoints_.erase(std::next(from), checkpoints_.end());
  words_ = step_words();
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
  return {copies(benches_), text_, names_, controls_, changes_.size()};
}

/// With these worlds in place of those of the moment.
void Playground::return_to(const Moment& moment, Benches benches) {
  const int changes = moment.changes;
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
  has_diverged_ = false;
  history_.keep(benches_[0]->snapshot());
  forget_solve();
  looks_ = std::move(looks);
  while (changes_.size() > changes) changes_.pop_back();  // the moment may go with them
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
