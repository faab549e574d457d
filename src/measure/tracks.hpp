// Floor 6. Numbers over time: what named bodies, joints and contacts of a run do.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// What the bodies and joints of a scene are called, and what its events count.
struct TrackNames {
  PerBody<std::string> bodies = {};            // of each body, the ground first
  std::map<std::string, JointId> joints = {};  // by name
  List<BodyId> sensors = {};                   // which bodies are sensors
  List<std::string> counters = {};             // CountTouches::counter of events
};

/// The sensors of a scene.
List<BodyId> sensors_of(const Scene& scene);
/// The counters of its events, by their names.
List<std::string> counters_of(const Scene& scene);

/// One quantity over time.
struct Track {
  std::string name = {};     // "ball.vy"
  std::string unit = {};     // "m/s"; "" of a pure number
  List<double> values = {};  // for each snapshot; NaN from where the body or joint was removed
};

/// What one body gives another in a step, by all of their contacts together.
struct PairImpulse {
  Vec2<double> push = {0, 0};  // [N s] on the second one
  double normal = 0;           // [N s]
  double friction = 0;         // [N s], on b along the normal turned by -90 degrees
  double overlap = 0;          // [m] the deepest
};

/// Keeps quantities of a run:
///   NAME.QUANTITY  of a body: x, y [m], angle [rad], vx, vy, speed [m/s], omega [rad/s], kinetic [J];
///                  of a joint: force, fx, fy [N] on its second body, impulse [N s], drift [m or rad],
///                  energy [J] of its springs;
///                  of a sensor: touching, how many bodies touch it; of a counter: count
///   A:B.QUANTITY   of all contacts of two bodies: force, fx, fy [N] on B, normal, friction [N], impulse
///                  [N s], overlap [m]
///   QUANTITY       of the scene: kinetic, potential, spring, energy [J], px, py [N s], angular_momentum
///                  [N m s] about the origin, contacts, overlap [m], drift [m or rad]
/// Any number of letters may be a '*': "*.y", "*:floor.force", "ball.*". Forces are means over a step where
/// snapshots have the impulses of whole steps (StepImpulses), as they are wherever there are no substeps.
class TrackRecorder {
 public:
  /// @throws std::invalid_argument for a pattern that nothing in the scene is called, with what it could be.
  /// Of contacts, pairs of known bodies are taken that do not touch yet.
  TrackRecorder(const List<std::string>& patterns, TrackNames names);
  TrackRecorder(const TrackRecorder&) = delete;
  TrackRecorder& operator=(const TrackRecorder&) = delete;

  /// The next snapshot of the run; the first has all of its bodies and joints.
  void add(const Snapshot& snapshot);

  /// In the order of the patterns; contacts that a '*' stands for come behind them, as they are met first.
  const List<Track>& tracks() const { return tracks_; }
  /// [s] Of each snapshot.
  const List<double>& times() const { return times_; }
  /// A row for each snapshot, or for each `every`th and the last: step, time_s, and each track with its unit,
  /// as "ball.vy_m_s". What has no number is an empty cell.
  CsvTable table(int every = 1) const;

 private:
  using Pair = std::pair<BodyId, BodyId>;
  using Source = std::function<double(const Snapshot&)>;

  static bool matches(const std::string& pattern, const std::string& text);
  bool take_scene(const std::string& pattern);
  bool take_bodies(const std::string& name, const std::string& quantity);
  bool take_joints(const std::string& name, const std::string& quantity);
  bool take_things(const std::string& name, const std::string& quantity);
  bool take_sensors(const std::string& name, const std::string& quantity);
  bool take_counters(const std::string& name, const std::string& quantity);
  bool take_pairs(const std::string& names, const std::string& quantity);
  void take_pair(const Pair& pair, const std::string& quantity);
  void meet_pairs();
  void add_track(const std::string& name, const std::string& unit, Source source);
  void refuse(const std::string& pattern) const;

  TrackNames names_;
  List<Track> tracks_;
  List<Source> sources_;                              // of each track
  List<std::pair<std::string, std::string>> of_any_;  // names and quantities of pairs that have a '*'
  std::map<Pair, PairImpulse> pairs_;                 // in the snapshot of the moment
  List<double> times_;
  List<int> steps_;
};

}  // namespace cairn
