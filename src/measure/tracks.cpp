// Floor 6. Quantities by name.
#include <cairn/measure/tracks.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/measure/violation.hpp>

namespace cairn {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A number that things of a kind have, which a step of dt [s] has left.
template <typename Thing>
struct Quantity {
  const char* name;
  const char* unit;
  double (*of)(const Thing&, double dt);
};

using OfBody = Quantity<SnapshotBody>;
const OfBody body_quantities[] = {
    {"x", "m", [](const SnapshotBody& body, double) { return body.pose.position.x(); }},
    {"y", "m", [](const SnapshotBody& body, double) { return body.pose.position.y(); }},
    {"angle", "rad", [](const SnapshotBody& body, double) { return body.pose.angle; }},
    {"vx", "m/s", [](const SnapshotBody& body, double) { return body.velocity.x(); }},
    {"vy", "m/s", [](const SnapshotBody& body, double) { return body.velocity.y(); }},
    {"speed", "m/s", [](const SnapshotBody& body, double) { return body.velocity.head<2>().norm(); }},
    {"omega", "rad/s", [](const SnapshotBody& body, double) { return body.velocity.z(); }},
    {"kinetic", "J", [](const SnapshotBody& body, double) { return kinetic_energy(body); }}};

double over_time(double impulse, double dt) { return dt > 0 ? impulse / dt : 0; }

using OfJoint = Quantity<SnapshotJoint>;
const OfJoint joint_quantities[] = {
    {"force", "N", [](const SnapshotJoint& joint, double dt) { return over_time(joint.impulse.norm(), dt); }},
    {"fx", "N", [](const SnapshotJoint& joint, double dt) { return over_time(joint.impulse.x(), dt); }},
    {"fy", "N", [](const SnapshotJoint& joint, double dt) { return over_time(joint.impulse.y(), dt); }},
    {"impulse", "N s", [](const SnapshotJoint& joint, double) { return joint.impulse.norm(); }},
    {"drift", "", [](const SnapshotJoint& joint, double) { return joint.drift; }},
    {"energy", "J", [](const SnapshotJoint& joint, double) { return joint.energy; }}};

using OfPair = Quantity<PairImpulse>;
const OfPair pair_quantities[] = {
    {"force", "N", [](const PairImpulse& pair, double dt) { return over_time(pair.push.norm(), dt); }},
    {"fx", "N", [](const PairImpulse& pair, double dt) { return over_time(pair.push.x(), dt); }},
    {"fy", "N", [](const PairImpulse& pair, double dt) { return over_time(pair.push.y(), dt); }},
    {"normal", "N", [](const PairImpulse& pair, double dt) { return over_time(pair.normal, dt); }},
    {"friction", "N", [](const PairImpulse& pair, double dt) { return over_time(pair.friction, dt); }},
    {"impulse", "N s", [](const PairImpulse& pair, double) { return pair.push.norm(); }},
    {"overlap", "m", [](const PairImpulse& pair, double) { return pair.overlap; }}};

double spring_energy(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotJoint& joint : snapshot.joints) sum += joint.energy;
  return sum;
}

using OfScene = Quantity<Snapshot>;
const OfScene scene_quantities[] = {
    {"kinetic", "J", [](const Snapshot& now, double) { return kinetic_energy(now); }},
    {"potential", "J",
     [](const Snapshot& now, double) { return potential_energy(now) - spring_energy(now); }},
    {"spring", "J", [](const Snapshot& now, double) { return spring_energy(now); }},
    {"energy", "J", [](const Snapshot& now, double) { return total_energy(now); }},
    {"px", "N s", [](const Snapshot& now, double) { return momentum(now).x(); }},
    {"py", "N s", [](const Snapshot& now, double) { return momentum(now).y(); }},
    {"angular_momentum", "N m s", [](const Snapshot& now, double) { return momentum(now).z(); }},
    {"contacts", "", [](const Snapshot& now, double) { return static_cast<double>(now.contacts.size()); }},
    {"overlap", "m", [](const Snapshot& now, double) { return worst_penetration(now); }},
    {"drift", "", [](const Snapshot& now, double) { return worst_joint_drift(now); }}};

bool has_star(const std::string& text) { return text.find('*') != std::string::npos; }

template <typename Thing, std::size_t count>
void add_names(const Quantity<Thing> (&all)[count], const std::string& before, List<std::string>& names) {
  for (const Quantity<Thing>& each : all) names.push_back(before + each.name);
}

/// What bodies give each other.
std::map<std::pair<BodyId, BodyId>, PairImpulse> pairs_of(const Snapshot& snapshot) {
  std::map<std::pair<BodyId, BodyId>, PairImpulse> pairs;
  for (const SnapshotContact& contact : snapshot.contacts) {
    const bool turned = contact.b < contact.a;
    PairImpulse& pair = pairs[turned ? std::pair(contact.b, contact.a) : std::pair(contact.a, contact.b)];
    const Vec2<double> along(contact.normal.y(), -contact.normal.x());
    const Vec2<double> push = contact.normal_impulse * contact.normal + contact.friction_impulse * along;
    pair.push += turned ? -push : push;
    pair.normal += contact.normal_impulse;
    pair.friction += contact.friction_impulse;
    pair.overlap = std::max(pair.overlap, -contact.separation);
  }
  return pairs;
}

/// "ball.vy" in m/s becomes "ball.vy_m_s".
std::string header_of(const Track& track) {
  std::string unit;
  for (const char c : track.unit) {
    if (c != ' ') unit += c == '/' ? '_' : c;
  }
  return unit.empty() ? track.name : track.name + "_" + unit;
}

}  // namespace

TrackRecorder::TrackRecorder(const List<std::string>& patterns, TrackNames names) : names_(std::move(names)) {
  for (const std::string& pattern : patterns) {
    const std::size_t dot = pattern.rfind('.');
    const std::string name = pattern.substr(0, dot);
    const std::string quantity = dot == std::string::npos ? "" : pattern.substr(dot + 1);
    const bool of_pair = name.find(':') != std::string::npos;
    const bool known = dot == std::string::npos ? take_scene(pattern)
                       : of_pair                ? take_pairs(name, quantity)
                                                : take_things(name, quantity);
    if (!known) refuse(pattern);
  }
}

bool TrackRecorder::take_scene(const std::string& pattern) {
  bool found = false;
  for (const OfScene& each : scene_quantities) {
    if (!matches(pattern, each.name)) continue;
    add_track(each.name, each.unit, [&each](const Snapshot& now) { return each.of(now, now.dt); });
    found = true;
  }
  return found;
}

bool TrackRecorder::take_bodies(const std::string& name, const std::string& quantity) {
  bool found = false;
  for (const BodyId id : names_.bodies.indices()) {
    if (id == ground || !matches(name, names_.bodies[id])) continue;
    for (const OfBody& each : body_quantities) {
      if (!matches(quantity, each.name)) continue;
      add_track(names_.bodies[id] + "." + each.name, each.unit, [&each, id](const Snapshot& now) {
        return id.index < now.bodies.size() && !now.bodies[id].removed ? each.of(now.bodies[id], now.dt)
                                                                       : nothing;
      });
      found = true;
    }
  }
  return found;
}

bool TrackRecorder::take_joints(const std::string& name, const std::string& quantity) {
  std::map<JointId, std::string> in_order;
  for (const auto& entry : names_.joints) in_order[entry.second] = entry.first;
  bool found = false;
  for (const auto& entry : in_order) {
    if (!matches(name, entry.second)) continue;
    for (const OfJoint& each : joint_quantities) {
      if (!matches(quantity, each.name)) continue;
      add_track(entry.second + "." + each.name, each.unit, [&each, id = entry.first](const Snapshot& now) {
        for (const SnapshotJoint& joint : now.joints) {
          if (joint.id == id) return each.of(joint, now.dt);
        }
        return nothing;
      });
      found = true;
    }
  }
  return found;
}

/// Named pairs at once; those that a '*' stands for once they touch.
bool TrackRecorder::take_pairs(const std::string& names, const std::string& quantity) {
  const bool known = std::any_of(std::begin(pair_quantities), std::end(pair_quantities),
                                 [&](const OfPair& each) { return matches(quantity, each.name); });
  const std::size_t colon = names.find(':');
  const std::string first = names.substr(0, colon), second = names.substr(colon + 1);
  if (has_star(names)) {
    of_any_.push_back({names, quantity});
    const auto is_met = [&](const std::string& part) {
      return std::any_of(names_.bodies.begin(), names_.bodies.end(),
                         [&](const std::string& name) { return matches(part, name); });
    };
    return known && is_met(first) && is_met(second);
  }
  const auto a = std::find(names_.bodies.begin(), names_.bodies.end(), first);
  const auto b = std::find(names_.bodies.begin(), names_.bodies.end(), second);
  if (!known || a == names_.bodies.end() || b == names_.bodies.end() || a == b) return false;
  take_pair({{static_cast<int>(a - names_.bodies.begin())}, {static_cast<int>(b - names_.bodies.begin())}},
            quantity);
  return true;
}

void TrackRecorder::take_pair(const Pair& pair, const std::string& quantity) {
  const bool turned = pair.second < pair.first;
  const Pair key = turned ? Pair(pair.second, pair.first) : pair;
  for (const OfPair& each : pair_quantities) {
    if (!matches(quantity, each.name)) continue;
    add_track(names_.bodies[pair.first] + ":" + names_.bodies[pair.second] + "." + each.name, each.unit,
              [this, &each, key, turned](const Snapshot& now) {
                const auto found = pairs_.find(key);
                PairImpulse given = found == pairs_.end() ? PairImpulse() : found->second;
                if (turned) given.push = -given.push;
                return each.of(given, now.dt);
              });
  }
}

/// Takes what touches for the first time; until then it gave nothing.
void TrackRecorder::meet_pairs() {
  for (const auto& [names, quantity] : of_any_) {
    for (const auto& entry : pairs_) {
      const Pair turned(entry.first.second, entry.first.first);
      const auto name_of = [&](const Pair& pair) {
        return names_.bodies[pair.first] + ":" + names_.bodies[pair.second];
      };
      const bool is_meant = matches(names, name_of(entry.first));
      if (is_meant || matches(names, name_of(turned))) take_pair(is_meant ? entry.first : turned, quantity);
    }
  }
}

void TrackRecorder::add_track(const std::string& name, const std::string& unit, Source source) {
  const auto is_it = [&](const Track& track) { return track.name == name; };
  if (std::any_of(tracks_.begin(), tracks_.end(), is_it)) return;
  tracks_.push_back({name, unit, List<double>(times_.size(), 0.0)});
  sources_.push_back(std::move(source));
}

void TrackRecorder::add(const Snapshot& snapshot) {
  pairs_ = pairs_of(snapshot);
  meet_pairs();
  for (int i = 0; i < tracks_.size(); ++i) tracks_[i].values.push_back(sources_[i](snapshot));
  times_.push_back(snapshot.time);
  steps_.push_back(snapshot.step);
}

CsvTable TrackRecorder::table(int every) const {
  require(every >= 1, "TrackRecorder::table", "every", ">= 1 snapshot", every);
  CsvTable table{.header = {"step", "time_s"}};
  for (const Track& track : tracks_) table.header.push_back(header_of(track));
  for (int i = 0; i < times_.size(); ++i) {
    if (i % every != 0 && i + 1 != times_.size()) continue;
    List<CsvCell> row = {static_cast<long long>(steps_[i]), times_[i]};
    for (const Track& track : tracks_) {
      const double value = track.values[i];
      row.push_back(std::isnan(value) ? CsvCell("") : CsvCell(value));
    }
    table.rows.push_back(row);
  }
  return table;
}

void TrackRecorder::refuse(const std::string& pattern) const {
  List<std::string> known;
  add_names(scene_quantities, "", known);
  for (const std::string& name : names_.bodies) add_names(body_quantities, name + ".", known);
  for (const auto& entry : names_.joints) add_names(joint_quantities, entry.first + ".", known);
  for (const BodyId sensor : names_.sensors) known.push_back(names_.bodies[sensor] + ".touching");
  for (const std::string& counter : names_.counters) known.push_back(counter + ".count");
  const std::string near = nearest(pattern, known);
  const std::string body = names_.bodies.size() > 1 ? names_.bodies[{1}] : "NAME";
  const std::string joint = names_.joints.empty() ? "" : ", " + names_.joints.begin()->first + ".force";
  require(false, "TrackRecorder", "track",
          near.empty()
              ? "a quantity such as energy, " + body + ".y" + joint + " or ground:" + body + ".normal"
              : "a known quantity (" + near + "?)",
          pattern);
}

}  // namespace cairn
