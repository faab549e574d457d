// A joint of this lesson's own, on three bodies.
#pragma once

#include <string>

#include <cairn/cairn.hpp>
#include <cairn/math/list.hpp>

namespace cairn::pulley {

/// One rope over fixed wheels, looped under a movable one. At body i hang r_i parts of it, of the length
/// top_i - y_i each:
///   c = length - sum r_i (top_i - y_i) >= 0,  j = (0, r_1, 0, 0, r_2, 0, 0, r_3, 0),  lambda >= 0
/// A rope pulls and never pushes, so its row is one-sided, and slack where c > 0.
// [joint]
class RopeOverWheels final : public ConstraintOf<RopeOverWheels> {
 public:
  struct End {
    BodyId body = {};
    double parts = 1;  // r_i
    double top = 0;    // [m] height from which the rope hangs
  };

  RopeOverWheels(const FixedList<End, 3>& ends, double length) : ends_(ends), length_(length) {}

  std::string name() const override { return "rope over wheels"; }
  List<Attachment> attachments() const override {
    return {{ends_[0].body, {0, 0}}, {ends_[1].body, {0, 0}}, {ends_[2].body, {0, 0}}};
  }
  bool bodies_collide() const override { return true; }

  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
    // [row]
    RowSpec<Real> row;
    row.error = static_cast<Real>(length_);
    for (const End& end : ends_) {
      const Real below = static_cast<Real>(end.top) - at[end.body].position.y();
      row.error -= static_cast<Real>(end.parts) * below;
    }
    row.a = ends_[0].body;
    row.b = ends_[1].body;
    row.jacobian_a = {0, static_cast<Real>(ends_[0].parts), 0};
    row.jacobian_b = {0, static_cast<Real>(ends_[1].parts), 0};
    row.extra[0] = {ends_[2].body, {0, static_cast<Real>(ends_[2].parts), 0}};  // the third body
    row.extra_count = 1;
    row.bounds = Bounds<Real>::unilateral();
    row.keeps_slop = false;  // a contact may keep an error as large as the slop (lesson 09); a rope may not
    rows.add(row);
    // [/row]
  }

 private:
  FixedList<End, 3> ends_;
  double length_;
};
// [/joint]

}  // namespace cairn::pulley
