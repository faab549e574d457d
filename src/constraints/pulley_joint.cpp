// Floor 3. The pulley joint's one row.
#include <cairn/constraints/pulley_joint.hpp>

#include <set>

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr int most_rope_bodies = 4;  // that a row has room for

/// The entries of a row of J, one for each body that is not the ground.
template <Scalar Real>
struct RopeTerms {
  FixedList<RowTerm<Real>, most_rope_bodies> terms = {};
  int count = 0;

  void add(BodyId body, const Vec3<Real>& jacobian) {
    if (body == ground) return;
    int i = 0;
    while (i < count && terms[i].body != body) ++i;
    if (i == count) terms[count++].body = body;
    terms[i].jacobian += jacobian;
  }
};

/// The row of these terms; a body alone stands against the ground.
template <Scalar Real>
RowSpec<Real> rope_row(const RopeTerms<Real>& rope) {
  RowSpec<Real> row;
  const int second = rope.count > 1 ? 1 : 0;
  if (second == 1) {
    row.a = rope.terms[0].body;
    row.jacobian_a = rope.terms[0].jacobian;
  }
  row.b = rope.terms[second].body;
  row.jacobian_b = rope.terms[second].jacobian;
  for (int i = 2; i < rope.count; ++i) {
    row.extra[row.extra_count++] = rope.terms[i];
  }
  return row;
}

template <Scalar Real>
void turn_sign(RowSpec<Real>& row) {
  row.error = -row.error;
  row.jacobian_a = -row.jacobian_a;
  row.jacobian_b = -row.jacobian_b;
  for (RowTerm<Real>& term : row.extra) term.jacobian = -term.jacobian;
}

void check_rope_end(const PulleyJoint::End& end, int bodies) {
  const auto require_body = [&](BodyId id, const char* field) {
    require(id.index >= 0 && id.index < bodies, "PulleyJoint", field, "the id of a body of this scene",
            id.index);
  };
  require_body(end.body, "end body");
  require_body(end.carrier, "end carrier");
  require(end.body != end.carrier, "PulleyJoint", "end carrier", "another body than the end's",
          end.carrier.index);
  require_finite(end.anchor, "PulleyJoint", "end anchor", "m");
  require_finite(end.roller, "PulleyJoint", "end roller", "m");
  require(end.parts > 0 && std::isfinite(end.parts), "PulleyJoint", "end parts", "a finite number > 0",
          end.parts);
}

/// The free rope of a part: from its roller to its anchor.
template <Scalar Real>
struct RopeLine {
  Vec2<Real> r_p, r_q;  // [m] arms of the anchor and of the roller
  Vec2<Real> d;         // [m] from the roller to the anchor
  Real distance;        // [m] |d|
};

template <typename Part, Scalar Real>
RopeLine<Real> rope_line(const Part& part, bool on_drum, const Placements<Real>& at) {
  const Placement<Real> body = at[part.body], carrier = at[part.carrier];
  const Vec2<Real> r_p = body.rotation * Vec2<Real>(part.anchor.template cast<Real>());
  Vec2<Real> r_q = part.roller.template cast<Real>();
  if (!on_drum) r_q = carrier.rotation * r_q;
  const Vec2<Real> d = body.position + r_p - carrier.position - r_q;
  return {r_p, r_q, d, d.norm()};
}

}  // namespace

PulleyJoint::PulleyJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : kind_(spec.kind), slack_margin_(spec.slack_margin) {
  require(!spec.ends.empty(), "PulleyJoint", "ends", "at least one", "none");
  std::set<BodyId> bodies;
  for (const End& end : spec.ends) {
    check_rope_end(end, poses.size());
    parts_.push_back(part_of(end, poses));
    bodies.insert({end.body, end.carrier});
    length_ += end.parts * (end.anchor - end.roller).norm();
  }
  bodies.erase(ground);
  require(bodies.size() <= most_rope_bodies, "PulleyJoint", "ends",
          "on at most 4 bodies besides the ground, carriers among them", static_cast<double>(bodies.size()));
  require_finite(spec.length, "PulleyJoint", "length", "m");
  if (!(spec.length < 0)) length_ = spec.length;
  require(length_ > 0 && std::isfinite(length_), "PulleyJoint", "length", "> 0 m and finite", length_);
  require(slack_margin_ >= 0 && std::isfinite(slack_margin_), "PulleyJoint", "slack_margin",
          "a finite number >= 0 m", slack_margin_);
}

PulleyJoint::Part PulleyJoint::part_of(const End& end, PerBodySpan<const Pose<double>> poses) {
  const Pose<double>& carrier = poses[end.carrier];
  Part part{.body = end.body, .carrier = end.carrier, .kind = end.kind, .count = end.parts};
  part.anchor = poses[end.body].local(end.anchor);
  part.roller = carrier.local(end.roller);
  if (end.kind == Roller::smooth) return part;

  require(end.carrier != ground, "PulleyJoint", "end carrier", "a body that can turn for a drum", 0);
  part.roller = end.roller - carrier.position;
  part.start_angle = carrier.angle;
  const Vec2<double> d = end.anchor - end.roller;
  part.winding = d.norm() > 0 ? cross(part.roller, d) / d.norm() : 0;
  require(part.winding != 0, "PulleyJoint", "end roller", "where a rope can leave its drum sideways",
          part.winding);
  return part;
}

List<double> PulleyJoint::parts() const {
  List<double> counts;
  for (const Part& part : parts_) counts.push_back(part.count);
  return counts;
}

List<Attachment> PulleyJoint::attachments() const {
  List<Attachment> line;
  for (int i = 0; i < parts_.size(); ++i) {
    const Attachment roller = roller_of(parts_[i]);
    if (i > 0) line.push_back(roller);
    line.push_back({parts_[i].body, parts_[i].anchor});
    if (i == 0 || i + 1 < parts_.size()) line.push_back(roller);
  }
  return line;
}

Attachment PulleyJoint::roller_of(const Part& part) const {
  return {.body = part.carrier, .anchor = part.roller, .turns = part.kind == Roller::smooth};
}

template <Scalar Real>
void PulleyJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  RopeTerms<Real> rope;
  Real length = 0;
  for (const Part& part : parts_) {
    const bool on_drum = part.kind == Roller::drum;
    const auto [r_p, r_q, d, distance] = rope_line(part, on_drum, at);
    if (!(distance > 0)) return;

    const Vec2<Real> u = d / distance;
    const Real count = static_cast<Real>(part.count);
    const Real winding = on_drum ? static_cast<Real>(part.winding) : cross(r_q, u);
    length += count * distance;
    if (on_drum) length -= count * winding * (at[part.carrier].angle - static_cast<Real>(part.start_angle));
    rope.add(part.body, count * Vec3<Real>(u.x(), u.y(), cross(r_p, u)));
    rope.add(part.carrier, count * Vec3<Real>(-u.x(), -u.y(), -winding));
  }
  RowSpec<Real> row = rope_row(rope);
  row.error = length - static_cast<Real>(length_);
  if (kind_ == Kind::rope) {
    if (-row.error > static_cast<Real>(slack_margin_)) return;
    turn_sign(row);
    row.bounds = Bounds<Real>::unilateral();
    row.keeps_slop = false;
  }
  rows.add(row);
}

template <Scalar Real>
void PulleyJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                          PerBody<Vec3<Real>>& stiffness) const {
  const Real tension = kind_ == Kind::rope ? forces.of(0) : -forces.of(0);
  for (const Part& part : parts_) {
    const bool on_drum = part.kind == Roller::drum;
    const auto [r_p, r_q, d, distance] = rope_line(part, on_drum, at);
    if (!(distance > 0)) return;
    const Vec2<Real> u = d / distance;
    const Real pull = static_cast<Real>(part.count) * tension;
    add_line_stiffness<Real>(part.body, r_p, -u, distance, pull, stiffness);
    // The rope leaves a drum at a point that does not turn with it.
    const Vec2<Real> arm = on_drum ? Vec2<Real>(0, 0) : r_q;
    add_line_stiffness<Real>(part.carrier, arm, u, distance, pull, stiffness);
  }
}

template class ConstraintOf<PulleyJoint>;

}  // namespace cairn
