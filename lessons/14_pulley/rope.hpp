// A joint of this lesson's own, on three bodies at once, and the scene that it holds.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cairn.hpp"

namespace cairn::pulley {

/// One rope over fixed wheels, looped under a movable one. At body i hang r_i parts of it, of the length
/// top_i - y_i each:
///   C = length - sum r_i (top_i - y_i) >= 0,  j = (0, r_1, 0, 0, r_2, 0, 0, r_3, 0),  lambda >= 0
/// A rope pulls and never pushes, so its row is one-sided, and slack where C > 0.
class RopeOverWheels final : public ConstraintOf<RopeOverWheels> {
 public:
  struct End {
    BodyId body = {};
    double parts = 1;  // r_i
    double top = 0;    // [m] height from which the rope hangs
  };

  RopeOverWheels(const std::array<End, 3>& ends, double length) : ends_(ends), length_(length) {}

  std::string name() const override { return "rope over wheels"; }
  std::vector<Attachment> attachments() const override {
    return {{ends_[0].body, {0, 0}}, {ends_[1].body, {0, 0}}, {ends_[2].body, {0, 0}}};
  }
  bool bodies_collide() const override { return true; }

  template <Scalar Real>
  void rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
    RowSpec<Real> row;
    row.error = static_cast<Real>(length_);
    for (const End& end : ends_) {
      const Pose<Real>& pose = poses[static_cast<std::size_t>(end.body.index)];
      row.error -= static_cast<Real>(end.parts) * (static_cast<Real>(end.top) - pose.position.y());
    }
    row.a = ends_[0].body;
    row.b = ends_[1].body;
    row.jacobian_a = {0, static_cast<Real>(ends_[0].parts), 0};
    row.jacobian_b = {0, static_cast<Real>(ends_[1].parts), 0};
    row.extra[0] = {ends_[2].body, {0, static_cast<Real>(ends_[2].parts), 0}};  // the third body
    row.extra_count = 1;
    row.bounds = Bounds<Real>::unilateral();
    row.keeps_slop = false;
    rows.push_back(row);
  }

 private:
  std::array<End, 3> ends_;
  double length_;
};

inline constexpr std::array<double, 3> parts = {1, 2, 1};  // r_i
inline constexpr double wheel_radius = 0.7;                // [m]
inline constexpr double wheel_height = 6;                  // [m] of the fixed wheels' middles

struct PulleySettings {
  double dt = 0.02;                          // [s]
  std::array<double, 3> masses = {1, 2, 3};  // [kg]
  int steps = 50;
  int lift_step = 20;  // after it the third mass is thrown upwards
  double lift = 3;     // [m/s]
};

/// What one step left behind.
struct PulleyStep {
  Snapshot snapshot = {};
  std::array<double, 3> speed = {};  // [m/s] upwards
  double tension = 0;                // lambda [N]
  double room = 0;                   // C [m]: 0 where the rope is taut
};

/// One solver's account of the whole fall.
struct PulleyRun {
  std::string solver = {};
  std::vector<PulleyStep> steps = {};  // steps[0] is the start
  std::size_t memory = 0;              // bytes beside the problem
};

struct PulleyRuns {
  PulleySettings settings = {};
  VelocityProblem<double> first = {};  // the problem of the first step
  std::vector<PulleyRun> runs = {};    // SI first, then six others
};

PulleyRuns run_pulleys(const PulleySettings& settings);

/// T = sum r_i g / sum r_i^2 / m_i [N], in the rope while it is taut.
double tension_by_formula(const PulleySettings& settings);

}  // namespace cairn::pulley
