// The derivative of every kind of constraint, compared with differences of its error.
#include "lesson.hpp"

#include <cairn/collision/collide.hpp>
#include "lessons/kit/random.hpp"

namespace cairn::one_row {

namespace {

constexpr double far_margin = 100;  // [m or rad] limits and slack ropes have their rows too
constexpr int random_rounds = 20;

using Poses = PerBody<Pose<double>>;
using Rows = std::function<RowSpecs<double>(const Poses&)>;

struct Kind {
  std::string name = {};
  Rows rows = {};
};

template <typename Joint>
Kind joint_kind(const std::string& name, const typename Joint::Spec& spec, const Poses& start) {
  return {name, [joint = Joint(spec, start)](const Poses& poses) {
            RowSpecs<double> rows;
            joint.append_rows(poses, rows);
            return rows;
          }};
}

/// A disc above a wide box. Without friction: its row has no error that it could be the derivative of.
Kind contact_kind() {
  return {"contact", [](const Poses& poses) {
            const Shape<double> disc = circle(0.3, {0.1, 0.2});
            const Manifold<double> manifold =
                collide<double>(disc, poses[{1}], box(40, 1), poses[{2}], far_margin);
            VelocityProblem<double> problem;
            problem.velocity.assign(poses.size(), Vec3<double>::Zero());
            problem.inverse_mass.assign(poses.size(), Vec3<double>::Ones());
            problem.rule.dt = 1;
            const Contact<double> contact{.a = {1},
                                          .b = {2},
                                          .manifold = manifold,
                                          .center_a = poses[{1}].position,
                                          .center_b = poses[{2}].position};
            int next = 0;
            write_contact_rows(contact, problem, next);
            RowSpec<double> row;
            row.a = problem.rows[0].a;
            row.b = problem.rows[0].b;
            row.error = manifold.points[0].separation;
            row.jacobian_a = problem.rows[0].jacobian_a;
            row.jacobian_b = problem.rows[0].jacobian_b;
            return RowSpecs<double>{row};
          }};
}

Vec2<double> random_point(Random& random, double reach) {
  const double x = random.between(-reach, reach);
  return {x, random.between(-reach, reach)};
}

/// The ground; two bodies one above the other, the lower one nearly level; a third beside them.
Poses random_poses(Random& random) {
  const Vec2<double> place = random_point(random, 2);
  const Vec2<double> below(random.between(-1, 1), random.between(-6, -4));
  Poses poses(4);
  poses[{1}] = {place, random.between(-pi, pi)};
  poses[{2}] = {place + below, random.between(-0.3, 0.3)};
  poses[{3}] = {place + Vec2<double>(4, 0), random.between(-pi, pi)};
  return poses;
}

Kind pulley_kind(const Vec2<double>& near_a, const Vec2<double>& near_b, const Poses& start) {
  const PulleyJoint::End left{.body = {1}, .anchor = near_a, .roller = near_a + Vec2<double>(0, 3)};
  const PulleyJoint::End right{
      .body = {2}, .anchor = near_b, .roller = near_b + Vec2<double>(2, 0), .parts = 2};
  return joint_kind<PulleyJoint>("pulley", {.ends = {left, right}, .slack_margin = far_margin}, start);
}

List<Kind> all_kinds(const Poses& start, Random& random) {
  const BodyId a{1}, b{2}, c{3};
  const Vec2<double> near_a = start[a].position + random_point(random, 1);
  const Vec2<double> near_b = start[b].position + random_point(random, 1);
  const Vec2<double> axis = Rotation<double>(random.between(-pi, pi)) * Vec2<double>(1, 0);
  const Softness soft = SwingSoftness{.frequency = 2, .damping_ratio = 0.5};
  return {
      joint_kind<DistanceJoint>("rod", {.a = a, .b = b, .anchor_a = near_a, .anchor_b = near_b}, start),
      joint_kind<DistanceJoint>("rope",
                                {.a = a,
                                 .b = b,
                                 .anchor_a = near_a,
                                 .anchor_b = near_b,
                                 .kind = DistanceJoint::Kind::rope,
                                 .slack_margin = far_margin},
                                start),
      joint_kind<RevoluteJoint>(
          "pin with limits",
          {.a = a, .b = b, .anchor = near_a, .lower = -0.1, .upper = 0.3, .limit_margin = far_margin}, start),
      joint_kind<PrismaticJoint>("slider with limits",
                                 {.a = a,
                                  .b = b,
                                  .anchor = near_a,
                                  .axis = axis,
                                  .lower = -0.1,
                                  .upper = 0.3,
                                  .limit_margin = far_margin},
                                 start),
      joint_kind<WeldJoint>("weld", {.a = a, .b = b, .anchor = near_a}, start),
      pulley_kind(near_a, near_b, start),
      joint_kind<GearJoint>("gear", {.a = a, .b = b, .c = c, .radius_a = 0.5, .radius_b = 1.5}, start),
      joint_kind<DifferentialJoint>("differential", {.a = a, .b = b, .c = c}, start),
      joint_kind<DragJoint>(
          "target joint", {.body = b, .anchor = near_b, .target = random_point(random, 3), .softness = soft},
          start),
      contact_kind(),
  };
}

/// The three numbers that a row has for one body.
Vec3<double> part_of(const RowSpec<double>& row, BodyId body) {
  Vec3<double> sum = Vec3<double>::Zero();
  if (row.a == body) sum += row.jacobian_a;
  if (row.b == body) sum += row.jacobian_b;
  for (int k = 0; k < row.extra_count; ++k) {
    const RowTerm<double>& term = row.extra[k];
    if (term.body == body) sum += term.jacobian;
  }
  return sum;
}

double largest_difference(const Rows& rows_at, const Poses& poses, double h) {
  const RowSpecs<double> rows = rows_at(poses);
  double largest = 0;
  for (const BodyId body : poses.indices()) {
    if (body == ground) continue;
    for (int k = 0; k < 3; ++k) {
      Poses ahead = poses, behind = poses;
      ahead[body] = carried(poses[body], Vec3<double>::Unit(k), h);
      behind[body] = carried(poses[body], Vec3<double>::Unit(k), -h);
      const RowSpecs<double> after = rows_at(ahead), before = rows_at(behind);
      for (int i = 0; i < rows.size(); ++i) {
        const double slope = (after.at(i).error - before.at(i).error) / (2 * h);
        const double entry = part_of(rows[i], body)(k);
        largest = std::max(largest, std::abs(slope - entry));
      }
    }
  }
  return largest;
}

}  // namespace

List<KindOfRows> compare_every_kind(std::uint64_t seed, double h) {
  List<KindOfRows> result;
  Random random(seed);
  for (int round = 0; round < random_rounds; ++round) {
    Poses poses = random_poses(random);
    const List<Kind> kinds = all_kinds(poses, random);
    for (const BodyId body : poses.indices()) {  // away from where the joints were made
      if (body == ground) continue;
      poses[body].position += random_point(random, 0.2);
      poses[body].angle += random.between(-0.2, 0.2);
    }
    result.resize(kinds.size());
    for (int k = 0; k < kinds.size(); ++k) {
      result[k].name = kinds[k].name;
      result[k].rows = kinds[k].rows(poses).size();
      result[k].error = std::max(result[k].error, largest_difference(kinds[k].rows, poses, h));
    }
  }
  return result;
}

}  // namespace cairn::one_row
