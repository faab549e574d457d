// What the rows of a joint or of a contact share: every product is counted as it is made.
#include "lesson.hpp"

#include "lessons/kit/random.hpp"

namespace cairn::blocks {

namespace {

/// Makes products, and counts them.
struct Products {
  int count = 0;

  double times(double a, double b) {
    ++count;
    return a * b;
  }
  double dot(const Vector<double>& a, const Vector<double>& b) {
    double sum = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) sum += times(a(i), b(i));
    return sum;
  }
  Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return {times(a.y(), b.z()) - times(a.z(), b.y()), times(a.z(), b.x()) - times(a.x(), b.z()),
            times(a.x(), b.y()) - times(a.y(), b.x())};
  }
};

/// Two bodies in space that move and turn, and a point of both, by its arms.
struct Meeting {
  Eigen::Vector3d v_a, v_b;          // [m/s]
  Eigen::Vector3d omega_a, omega_b;  // [rad/s]
  Eigen::Vector3d r_a, r_b;          // [m]
};

Eigen::Vector3d anything(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

/// Of the planar case only x and y of places are not 0, and only z of turns.
Meeting some_meeting(Random& random, bool is_planar) {
  Meeting both{anything(random), anything(random), anything(random),
               anything(random), anything(random), anything(random)};
  if (!is_planar) return both;
  for (Eigen::Vector3d* place : {&both.v_a, &both.v_b, &both.r_a, &both.r_b}) place->z() = 0;
  for (Eigen::Vector3d* turn : {&both.omega_a, &both.omega_b}) turn->head<2>().setZero();
  return both;
}

/// A row along `way` by itself: its j, six numbers in the plane and twelve in space, times v.
double by_row(Products& made, const Meeting& both, const Eigen::Vector3d& way, bool is_planar) {
  Products known;  // those of j, which does not change while iterating, are not counted
  const Eigen::Vector3d turn_a = known.cross(both.r_a, way), turn_b = known.cross(both.r_b, way);
  if (is_planar) {
    const Vector<double> j{{-way.x(), -way.y(), -turn_a.z(), way.x(), way.y(), turn_b.z()}};
    const Vector<double> v{
        {both.v_a.x(), both.v_a.y(), both.omega_a.z(), both.v_b.x(), both.v_b.y(), both.omega_b.z()}};
    return made.dot(j, v);
  }
  Vector<double> j(12), v(12);
  j << -way, -turn_a, way, turn_b;
  v << both.v_a, both.omega_a, both.v_b, both.omega_b;
  return made.dot(j, v);
}

/// [m/s] How fast the point of b leaves that of a: what all rows of the point need.
Eigen::Vector3d apart(Products& made, const Meeting& both, bool is_planar) {
  if (!is_planar)
    return both.v_b + made.cross(both.omega_b, both.r_b) - both.v_a - made.cross(both.omega_a, both.r_a);
  const auto point = [&made](const Eigen::Vector3d& v, double omega, const Eigen::Vector3d& r) {
    return Eigen::Vector3d(v.x() - made.times(omega, r.y()), v.y() + made.times(omega, r.x()), 0);
  };
  return point(both.v_b, both.omega_b.z(), both.r_b) - point(both.v_a, both.omega_a.z(), both.r_a);
}

}  // namespace

SharedWork count_shared() {
  Random random(1);
  SharedWork work;
  const Meeting plane = some_meeting(random, true), space = some_meeting(random, false);
  const auto compare = [&work](double shared, double alone) {
    work.gap = std::max(work.gap, std::abs(shared - alone));
  };
  Products rows, block;
  const Eigen::Vector3d weld = apart(block, plane, true);
  for (const int axis : {0, 1}) compare(weld(axis), by_row(rows, plane, Eigen::Vector3d::Unit(axis), true));
  rows.dot(Vector<double>::Ones(6), Vector<double>::Ones(6));  // θ: j = (0, 0, −1, 0, 0, 1)
  work.weld_rows = rows.count;
  work.weld_block = block.count;
  for (const bool is_planar : {true, false}) {
    const Meeting& both = is_planar ? plane : space;
    const Eigen::Vector3d normal =
        is_planar ? Eigen::Vector3d(0.6, 0.8, 0) : Eigen::Vector3d(2.0 / 3, 1.0 / 3, 2.0 / 3);
    const Eigen::Vector3d side =
        is_planar ? Eigen::Vector3d(0.8, -0.6, 0) : Eigen::Vector3d(1.0 / 3, 2.0 / 3, -2.0 / 3);
    List<Eigen::Vector3d> ways = {normal, side};
    if (!is_planar) ways.push_back({-2.0 / 3, 2.0 / 3, 1.0 / 3});
    Products alone, shared;
    const Eigen::Vector3d speed = apart(shared, both, is_planar);
    for (const Eigen::Vector3d& way : ways) {
      const double along = is_planar ? shared.dot(way.head<2>(), speed.head<2>()) : shared.dot(way, speed);
      compare(along, by_row(alone, both, way, is_planar));
    }
    (is_planar ? work.contact_rows : work.space_rows) = alone.count;
    (is_planar ? work.contact_shared : work.space_shared) = shared.count;
  }
  return work;
}

void print_shared(Lesson& lesson, const SharedWork& work) {
  lesson.print(
      fmt::format("  products for j·v, row by row and from the velocity of the point: a weld {} and {},",
                  work.weld_rows, work.weld_block));
  lesson.print(
      fmt::format("  a contact with friction {} and {}, one in space with two friction rows {} and {}",
                  work.contact_rows, work.contact_shared, work.space_rows, work.space_shared));
}

void check_shared(Lesson& lesson, const SharedWork& work) {
  // A dozen products of numbers up to 1.
  lesson.check_small("j·v from the velocity of the point, or row by row: difference (m/s)", work.gap,
                     16 * epsilon * 12);
  lesson.check_that("a weld as a block makes fewer products for j·v than three rows",
                    work.weld_block < work.weld_rows,
                    fmt::format("{} < {}", work.weld_block, work.weld_rows));
  const double one_row = 1.0 * work.contact_shared / work.contact_rows;
  const double two_rows = 1.0 * work.space_shared / work.space_rows;
  lesson.check_that("contact and friction share products, with two friction rows more than with one",
                    two_rows < one_row && one_row < 1, fmt::format("{:.2f} < {:.2f} < 1", two_rows, one_row));
}

}  // namespace cairn::blocks
