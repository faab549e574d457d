// Running: steps, rows and sweeps.
#include "lessons/playground/playground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/deadline.hpp>
#include "render/page.hpp"
#include <cairn/scenes/default_setting.hpp>
#include <cairn/scenes/scene_file.hpp>

namespace cairn::playground {

namespace {

constexpr int steps_a_checkpoint = 30;
constexpr double seconds_a_checkpoint = 0.25;  // of computing, where steps are slow
constexpr int updates_a_frame = 50'000;        // of rows, in search of their ends
constexpr int updates_at_rest = 2'000'000;     // which take about as long as a student waits
constexpr double floor_depth = 3;              // times as deep as the ground is thick
constexpr double floor_end = 1e4;              // [m] to each side
constexpr double far_end = 5;  // times the largest force: an end further off is not waited for

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// So that it has the forces of all rows, but those that are larger than `largest` [N].
void widen(ForceRange& range, const VelocityProblem<double>& problem, const PerRow<double>& impulse,
           double largest) {
  for (int i = 0; i < impulse.size(); ++i) {
    const double force = impulse[i] / problem.dt;
    if (std::abs(force) <= largest) range = {std::min(range.least, force), std::max(range.most, force)};
  }
}

/// A floor without an end, deep under the ground: what leaves the ground lands there. Where bodies begin
/// below the ground they have room to fall.
void add_floor(Scene& scene) {
  const auto reach = [&](BodyId id) {  // [m] from its lowest point to its highest
    std::pair range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (const Shape<double>& shape : scene.bodies()[id].spec.shapes) {
      const Aabb<double> box = bounding_box<double>(shape, scene.bodies()[id].pose);
      range = {std::min(range.first, box.lower.y()), std::max(range.second, box.upper.y())};
    }
    return range;
  };
  const auto [bottom, top] = reach(ground);
  if (std::isinf(bottom) || !(scene.settings().gravity.y() < 0)) return;
  for (const BodyId id : scene.bodies().indices())
    if (reach(id).first < bottom) return;
  scene.add_ground({.height = top - floor_depth * (top - bottom),
                    .half_width = floor_end,
                    .material = scene.bodies()[ground].spec.material});
}

/// As strong as the controls have it, the way that the scene has it.
void give_gravity(Scene& scene, double strength) {
  SceneSettings settings = scene.settings();
  const double now = settings.gravity.norm();
  settings.gravity = now > 0 ? Vec2<double>(settings.gravity * (strength / now)) : Vec2<double>(0, -strength);
  scene.set_settings(settings);
}

/// Sweeps are to be seen: those of sequential impulses, where the scene names no solver.
Setting swept(const SceneEntry& entry) {
  Setting setting = entry.setting;
  const Scene scene = entry.make();
  const Setting usual = default_setting(scene).setting;
  if (setting.solver != usual.solver) return setting;
  setting.solver = scene.joints().empty() ? "si" : "block";
  if (setting.sweeps.iterations == usual.sweeps.iterations) setting.sweeps.iterations = 10;
  if (scene.joints().empty() && setting.substeps == usual.substeps)
    setting.substeps = scene.settings().substeps;
  return setting;
}

}  // namespace

Playground::Playground() { open("title = \"an empty scene\"\n\n[ground]\nhalf_width = 8\n", "empty"); }

void Playground::open(const std::string& text, const std::string& file) {
  const SceneEntry entry = read_scene_text(text, file);
  Controls controls{.setting = swept(entry)};
  controls.other = controls_.other;
  controls.gravity = entry.make().settings().gravity.norm();
  begin(entry, controls);
  recommended_ = {.setting = controls.setting, .gravity = controls.gravity};
  text_ = text;
  file_ = file;
  words_ = fmt::format("{}. {}", entry_.title, entry_.look);
}

void Playground::restart() {
  begin(entry_, controls_);
  words_ = "At the start.";
}

/// All anew; or, where the scene or the setting is refused, nothing.
void Playground::begin(const SceneEntry& entry, const Controls& controls) {
  const Scene start = entry.make();
  Scene scene = start;
  add_floor(scene);
  give_materials(scene, start, entry.body_names, entry.body_names, controls);
  if (controls.gravity != start.settings().gravity.norm()) give_gravity(scene, controls.gravity);
  List<std::unique_ptr<Bench>> benches;
  benches.push_back(make_bench(scene, controls.setting));
  if (controls.other) {
    Setting setting = controls.setting;
    setting.solver = *controls.other;
    benches.push_back(make_bench(scene, setting));
  }
  List<SolveLook> looks = looks_of(benches);
  entry_ = entry;
  start_ = start;
  controls_ = controls;
  benches_ = std::move(benches);
  first_ = benches_[0]->snapshot();
  names_ = entry.body_names;
  changes_.clear();
  end_.reset();
  is_changed_ = false;
  prediction_.reset();
  lit_row_ = -1;
  has_diverged_ = false;
  forces_ = {};
  step_seconds_ = 0;
  checkpoints_.clear();
  history_ = History(most_steps_back);
  history_.keep(first_);
  forget_solve();
  looks_ = std::move(looks);
}

void Playground::set(const std::string& control, const std::string& value) {
  Controls next = controls_;
  set_control(next, recommended_, control, value);
  if (!can_go_on(controls_, next)) {
    begin(entry_, next);
    words_ = "From the start, for this cannot change while the scene runs.";
    return;
  }
  stay_here();
  Benches benches = copies(benches_);
  if (next.other && benches.size() == 1) benches.push_back(benches_[0]->copy());
  if (!next.other && benches.size() == 2) benches.pop_back();
  for (int i = 0; i < benches.size(); ++i) {
    Setting setting = next.setting;
    if (i == 1) setting.solver = *next.other;
    benches[i]->set(setting);
    benches[i]->edit([&](Scene& scene) {
      give_materials(scene, start_, names_, entry_.body_names, next);
      if (next.gravity != controls_.gravity) give_gravity(scene, next.gravity);
    });
  }
  List<SolveLook> looks = looks_of(benches);
  benches_ = std::move(benches);
  controls_ = next;
  is_changed_ |= benches_[0]->steps() > 0;
  forget_solve();
  looks_ = std::move(looks);
  keep_now();
  words_ = control_text(controls_, control) + ".";
}

void Playground::set_patience(double seconds) {
  require(seconds >= 0 && std::isfinite(seconds), "patience", "seconds", "finite and not below 0", seconds);
  patience_ = seconds;
}

void Playground::in_time(const std::function<void()>& act) const {
  try {
    const Deadline deadline(patience_);
    act();
  } catch (const TimeUp&) {
    throw std::runtime_error(fmt::format(
        "One step takes longer than {:g} s here, and the playground waits no longer: take another solver, or "
        "fewer sweeps or substeps.",
        patience_));
  }
}

void Playground::step(int count, double seconds) {
  require(count >= 1 && count <= most_steps, "step", "count", fmt::format("from 1 to {}", most_steps), count);
  require(seconds >= 0, "step", "seconds", "not below 0", seconds);
  if (has_diverged_)
    throw std::invalid_argument("There is no next step: a body would be at no finite place.");
  stay_here();
  const double end = seconds_now() + seconds;
  all_or_nothing([&] {
    for (int i = 0; i < count && !has_diverged_ && (i == 0 || seconds_now() < end); ++i) take_step();
  });
  words_ = step_words();
}

void Playground::take_step() {
  if (checkpoints_.empty() || since_checkpoint_ >= seconds_a_checkpoint ||
      benches_[0]->steps() - checkpoints_.back().benches[0]->steps() >= steps_a_checkpoint) {
    keep_now();
  }
  in_time([&] {
    for (int i = 0; i < benches_.size(); ++i) {
      const double begun = seconds_now();
      const StepReport report = benches_[i]->step();
      const double took = seconds_now() - begun;
      since_checkpoint_ += took;
      if (i > 0) continue;
      step_seconds_ = took;
      has_diverged_ = report.not_finite.has_value();
      history_.keep(benches_[0]->snapshot());
    }
  });
}

void Playground::forget_solve() {
  cursor_.reset();
  ends_.reset();
  forget_look();
}

List<SolveLook> Playground::looks_of(const Benches& benches, int updates) const {
  List<SolveLook> looks;
  in_time([&] {
    for (const auto& bench : benches) looks.push_back(bench->look(updates));
  });
  return looks;
}

const SolveLook& Playground::look(int number) const {
  if (looks_.empty()) looks_ = looks_of(benches_, cursor_.value_or(-1));
  return looks_[number];
}

const PerRow<double>& Playground::ends() const {
  const bool is_rough = is_moving_ && !cursor_;
  if (!ends_ || (are_ends_rough_ && !is_rough)) {
    ends_ = where_sweeps_end(look(0).given, is_rough ? updates_a_frame : updates_at_rest);
    are_ends_rough_ = is_rough;
  }
  return *ends_;
}

ForceRange Playground::forces() const {
  const SolveLook& now = look(0);
  ForceRange needed = cursor_ ? forces_ : ForceRange{}, of_ends;
  widen(needed, now.given, now.impulse, std::numeric_limits<double>::max());
  // Rows that contradict each other end where they leave no room for anything else: such ends are left out.
  widen(of_ends, now.given, ends(), far_end * needed.largest());
  needed = {std::min(needed.least, 1.25 * of_ends.least), std::max(needed.most, 1.25 * of_ends.most)};
  const bool is_too_wide = forces_.largest() > 4 * needed.largest();
  forces_ = is_too_wide
                ? needed
                : ForceRange{std::min(forces_.least, needed.least), std::max(forces_.most, needed.most)};
  return forces_;
}

void Playground::predict(int row, double force) {
  const SolveLook& now = look(0);
  require(row >= 0 && row < now.given.row_count(), "predict", "row", "a row of the next step", row);
  require(std::isfinite(force), "predict", "force", "finite", force);
  prediction_ = {.row = row, .force = force};
  words_ = fmt::format("You think that row {} ends at {} newtons.", row + 1, render::readable(force, 2));
}

void Playground::reveal() {
  if (!prediction_) throw std::invalid_argument("There is no prediction to compare with.");
  prediction_->is_revealed = true;
  const SolveLook& now = look(0);
  const double end = prediction_->row < ends().size() ? ends()[prediction_->row] / now.given.dt : 0;
  words_ = fmt::format("Row {} ends at {} newtons: you are {} off.", prediction_->row + 1,
                       render::readable(end, 2), render::readable(std::abs(end - prediction_->force), 2));
}

std::string Playground::step_words() const {
  if (has_diverged_) return "The world has diverged: a body would be at no finite place. Go back by a step.";
  const SolveLook& now = look(0);
  return fmt::format("Step {}, {:.3f} seconds: {} rows, residual {:.2g}.", benches_[0]->steps(),
                     benches_[0]->snapshot().time, now.given.row_count(), now.residuals.back());
}

}  // namespace cairn::playground
