// A scene in a student's hand: the text it comes from, one or two worlds that run it, and the way back.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include <cairn/geometry/aabb.hpp>
#include <cairn/math/list.hpp>
#include "lessons/playground/bench.hpp"
#include "lessons/playground/controls.hpp"
#include "lessons/playground/history.hpp"
#include <cairn/scenes/scene_list.hpp>

namespace cairn::playground {

/// Where a student thinks that a row ends.
struct Prediction {
  int row = 0;
  double force = 0;          // [N] lambda
  bool is_revealed = false;  // where it does end may be seen
};

/// Of impulses over the step, lambda.
struct ForceRange {
  double least = 0;  // [N] not above zero
  double most = 0;   // [N] not below zero

  double largest() const { return std::max(-least, most); }
};

/// Every function refuses with std::invalid_argument, or what a World throws, and then has changed nothing.
class Playground {
 public:
  static constexpr int most_steps_back = 600;
  static constexpr int most_steps = 100'000;  // at a time

  /// Begins with an empty scene.
  Playground();

  /// From the text of a scene file; `file` is the name that messages give it.
  void open(const std::string& text, const std::string& file);
  /// From the scene's start, under the settings of now.
  void restart();
  /// As set_control().
  void set(const std::string& control, const std::string& value);

  /// While the picture moves, the ends of rows are sought only as far as a frame has time for.
  void set_moving(bool is_moving) { is_moving_ = is_moving; }
  /// How long a step may take, and a look at the next one [s]; 0, as at first: for as long as it takes. What
  /// takes longer is refused, and with it what led there.
  void set_patience(double seconds);
  /// To the end of the step under way, and so many in all; or fewer, where the world diverges, or where so
  /// many seconds have passed before the next one begins.
  void step(int count, double seconds = std::numeric_limits<double>::infinity());
  /// So many row updates on within the next step's first solve.
  void advance_rows(int count);
  /// To the end of the sweep under way.
  void advance_sweep();
  /// Before the step under way, or else before the last one, with the bodies and the settings of then.
  void back();
  /// Shows another of the steps that are kept; the later ones stay until something is done from here.
  void visit(int step);
  /// The step under way after so many of its row updates; 0: not begun.
  void visit_row(int updates);

  /// The hand takes hold of the body at a point [m], or as near as `near` [m].
  void grab(const Vec2<double>& point, double near);
  /// And pulls to another [m].
  void drag(const Vec2<double>& target);
  void let_go();

  /// A box of this size with its middle there [m].
  void add_box(const Vec2<double>& middle, const Vec2<double>& size);
  /// A disc of this radius [m].
  void add_ball(const Vec2<double>& middle, double radius);
  /// Walls on all sides of a room [m]. They are one body, which does not move.
  void add_walls(const Aabb<double>& room);
  /// A rope of short links between two points [m], pinned to a body at each; both may be the ground.
  void add_rope(BodyId a, const Vec2<double>& from, BodyId b, const Vec2<double>& to);
  void remove(BodyId body);
  /// Pins b to a at a point [m].
  void pin(BodyId a, BodyId b, const Vec2<double>& point);
  /// Takes the last of these changes back.
  void undo();

  void light_row(int row) { lit_row_ = std::max(row, -1); }
  void predict(int row, double force);
  void reveal();

  /// The file as it stands with what was changed since it was opened.
  const std::string& text() const { return text_; }
  const SceneEntry& entry() const { return entry_; }
  const Controls& controls() const { return controls_; }
  const Controls& recommended() const { return recommended_; }
  /// The first world at its start.
  const Snapshot& first() const { return first_; }
  /// The worlds, one for each solver.
  int bench_count() const { return benches_.size(); }
  const Bench& bench(int number) const { return *benches_[number]; }
  /// The next solve of a world: up to where the student is in the step under way, or all of it.
  const SolveLook& look(int number) const;
  /// Where the first world's next solve would end [N s], an impulse a row.
  const PerRow<double>& ends() const;
  const PerBody<std::string>& names() const { return names_; }
  /// Row updates done in the step under way; none where there is no such step.
  std::optional<int> cursor() const { return cursor_; }
  int steps_back() const;
  /// The last of the steps that visit() leads to.
  int last_step() const;
  /// Whether a hand pulled, or the scene or a setting changed after the first step: then the text and the
  /// settings alone do not lead here.
  bool is_touched() const { return is_changed_ || !benches_[0]->hand_inputs().empty(); }
  int lit_row() const { return lit_row_; }
  const std::optional<Prediction>& prediction() const { return prediction_; }
  /// [s] the first world's last step.
  double step_seconds() const { return step_seconds_; }
  /// The first world has no next step: a body would be at no finite place.
  bool has_diverged() const { return has_diverged_; }
  /// Of all rows, and a quarter more than that of their ends: now, or since the start unless that was more
  /// than four times as much. For a scale that stands still.
  ForceRange forces() const;
  /// What the first world did at the steps that can be taken back, and now.
  const History& history() const { return history_; }
  /// What has changed, in a sentence.
  const std::string& words() const { return words_; }

 private:
  using Benches = List<std::unique_ptr<Bench>>;
  /// All that a way back leads to.
  struct Moment {
    Benches benches = {};
    std::string text = {};
    PerBody<std::string> names = {};
    Controls controls = {};
    int changes = 0;  // that undo() can take back
    bool is_changed = false;
    bool has_diverged = false;
  };
  struct Change {
    Moment before = {};
    std::string words = {};
  };

  static Benches copies(const Benches& benches);
  Moment now() const;
  void take_over(const Moment& moment, Benches benches);
  void return_to(const Moment& moment, Benches benches);
  Benches replayed(const Moment& from, const List<HandInput>& inputs, int target) const;
  std::deque<Moment>::iterator kept_before(int step);
  void stay_here();
  void keep_now();
  void begin(const SceneEntry& entry, const Controls& controls);
  static void give_materials(Scene& scene, const Scene& start, const PerBody<std::string>& names,
                             const PerBody<std::string>& start_names, const Controls& controls);
  void edit(const std::string& addition, const std::string& words, const PerBody<std::string>& names,
            const std::function<void(Scene&)>& change);
  void all_or_nothing(const std::function<void()>& act);
  void in_time(const std::function<void()>& act) const;
  List<SolveLook> looks_of(const Benches& benches, int updates = -1) const;
  void take_step();
  bool go_to_row(int next);
  void forget_look() const { looks_.clear(); }
  void forget_solve();
  std::string unused_name(const std::string& kind) const;
  void add_body(const std::string& kind, const std::string& shape, const Vec2<double>& middle,
                const std::string& words);
  void require_bodies(const char* act, std::initializer_list<BodyId> bodies) const;
  Vec2<double> point_in_file(BodyId body, const Vec2<double>& point) const;
  std::string step_words() const;

  std::string text_;
  std::string file_ = "scene";
  SceneEntry entry_;
  Scene start_;
  Controls controls_;
  Controls recommended_;
  Benches benches_;
  Snapshot first_;
  PerBody<std::string> names_;
  std::deque<Moment> checkpoints_;
  History history_{most_steps_back};
  double since_checkpoint_ = 0;  // [s] of computing
  List<Change> changes_;
  std::optional<Moment> end_;  // while an earlier step is visited
  int visited_changes_ = 0;    // of that step
  bool is_changed_ = false;
  mutable List<SolveLook> looks_;
  mutable std::optional<PerRow<double>> ends_;
  mutable bool are_ends_rough_ = false;
  std::optional<int> cursor_;
  int lit_row_ = -1;
  std::optional<Prediction> prediction_;
  double patience_ = 0;  // [s]
  double step_seconds_ = 0;
  bool has_diverged_ = false;
  bool is_moving_ = false;
  mutable ForceRange forces_;
  std::string words_;
};

}  // namespace cairn::playground
