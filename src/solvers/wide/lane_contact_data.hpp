// Floor 4. Contacts side by side in lanes: what the code of every instruction set reads and writes.
#pragma once

#include <cairn/constraints/row_rule.hpp>
#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

/// Points of a contact, at most.
inline constexpr int most_lane_points = 2;
/// Rows of a contact, at most: of every point the normal one, then that of friction where there is any.
inline constexpr int most_contact_rows = 4;

/// What is gathered of a batch of contacts.
template <typename Real>
struct LaneContactInput {
  Real center_a[2][lane_count];                   // [m] of mass, of the first bodies
  Real center_b[2][lane_count];                   // [m] of the second bodies
  Real normal[2][lane_count];                     // n, from the first to the second
  Real point[most_lane_points][2][lane_count];    // [m]
  Real separation[most_lane_points][lane_count];  // [m]
  Real rigid[most_lane_points][lane_count];       // 1 where no spring holds it, or 0
  Real slop_limit[lane_count];                    // [m]
};

/// What contacts are weighed for: both sums that R_E is made of (residual.hpp).
enum class LaneEnergy {
  at_start,   // with no impulses at all, at the velocities that a step starts from
  of_answer,  // of what the answer still asks for
};

/// A batch of contacts in the problem's own precision: what its rows say, in fewer numbers.
template <typename Real>
struct alignas(64) LaneContactBatch {
  int points = 0;                               // of each contact
  bool has_friction = false;                    // there are rows of friction
  Real inverse_a[3][lane_count];                // the inverse masses of the first bodies
  Real inverse_b[3][lane_count];                // of the second bodies
  Real normal[2][lane_count];                   // n
  Real turn_a[most_contact_rows][lane_count];   // [m] r_a x direction of each row
  Real turn_b[most_contact_rows][lane_count];   // [m] r_b x direction of each row
  Real inverse[most_contact_rows][lane_count];  // [1/kg] A_ii of each row, without softness
  Real bias[most_lane_points][lane_count];      // [m/s] of the normal rows
  Real softness[most_lane_points][lane_count];  // [1/kg] of the normal rows
  Real friction[lane_count];                    // mu
  Real rebound[most_lane_points][lane_count];   // [m/s]
  Real impulse[most_contact_rows][lane_count];  // [N s] of each row, where the lanes were filled
  Real answer[most_contact_rows][lane_count];   // [N s] as written back last; before, the warm start

  /// Of each contact.
  int rows() const { return has_friction ? 2 * points : points; }
};

}  // namespace cairn
