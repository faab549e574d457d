// Floor 4. Rows side by side in lanes: what the sweeps of every instruction set read and write.
#pragma once

#include <cstdint>

namespace cairn {

/// Blocks in a batch, whatever the instruction set: so that all sets do the same, number for number.
inline constexpr int lane_count = 16;
/// Rows of a block in a lane, at most.
inline constexpr int most_lane_rows = 6;

/// One row of each block of a batch, scaled so that A_ii is 1. Impulses are changes since the lanes were
/// filled, over `scale`; velocities are changes over the roots of the inverse masses. Functions that read it
/// are compiled for several instruction sets: it has none of its own, and no type of Eigen.
struct alignas(64) LaneRow {
  float jacobian_a[3][lane_count];  // of the first body
  float jacobian_b[3][lane_count];  // of the second body
  float lacking[lane_count];        // bias - j v - softness * impulse where the lanes were filled
  float impulse[lane_count];        // the unknown: its change
  float lower[lane_count];          // of the impulse
  float upper[lane_count];          // of the impulse
  float friction[lane_count];       // by how much a normal impulse [N s] moves both of these
  float softness[lane_count];       // of the impulse
  float scale[lane_count];          // [N s] of an impulse of 1
};

/// An entry of A between two rows of a block, times omega: one for each block of a batch.
struct alignas(64) LaneCoupling {
  float entry[lane_count];  // one for each lane
};

/// Impulses of one row of each block of a batch, as LaneRow has them.
struct alignas(64) LaneImpulse {
  float impulse[lane_count];  // one for each lane
};

/// What a row compares its impulse with.
enum class LaneBounds : std::uint8_t {
  none,             // an equality
  lower,            // a contact's normal, or a limit
  both,             // a motor
  friction,         // of one row of its block
  friction_of_two,  // of two rows of its block
};

/// What one row of a batch has in common in all lanes.
struct LaneKind {
  LaneBounds bounds = LaneBounds::none;  // which of the bounds are read
  std::uint8_t normal = 0;               // the row in the block that friction leans on
  std::uint8_t second_normal = 0;        // and the other one
};

/// Blocks of the same kinds of rows of which no two share a body that can move: one in each lane.
struct LaneBatch {
  int first_row = 0;        // in the list of LaneRow
  int rows = 0;             // in each of the blocks
  bool is_contact = false;  // with friction: one row after the other normal and friction that leans on it
  int contacts = -1;        // number among the batches of contacts without rows; -1: its blocks have rows
  int first_kind = 0;       // in the list of LaneKind
  int first_coupling = 0;   // in the list of LaneCoupling: of row 1 with row 0, of row 2 with 0, 1 ...
  int used = 0;             // lanes with a block; in the others nothing acts
  unsigned moves_a = 0;     // the lanes whose first body can move, a bit each: others may be in any batch
  unsigned moves_b = 0;     // and those whose second body can
  std::int32_t body_a[lane_count];     // the first body of each block; of none, one that nothing moves
  std::int32_t body_b[lane_count];     // the second body
  std::int32_t block_row[lane_count];  // the problem's row that is the block's first
  std::int32_t block[lane_count];      // its number; of contacts without rows, that of the contact
};

/// A body's velocity, or its change over the root of the inverse mass: x, y, rotation and a number that is
/// always 0. Or where it is: x, y, and the cosine and the sine of its angle.
template <typename Real>
struct alignas(4 * sizeof(Real)) LaneBody {
  Real numbers[4];  // side by side
};

/// What a sweep over batches works on.
struct LaneProblem {
  const LaneBatch* batches = nullptr;       // in the order of a sweep
  const LaneKind* kinds = nullptr;          // of their rows
  const LaneCoupling* couplings = nullptr;  // between these
  LaneRow* rows = nullptr;                  // all of them
  LaneBody<float>* bodies = nullptr;        // all, and one that nothing moves
  LaneImpulse* before = nullptr;            // of each row: where the last sweep began
  float relaxation = 1;                     // omega
  float momentum = 0;                       // what a step begins with is so much of the last one
  float largest_change[lane_count] = {};    // [N s] of an impulse in each lane: sweeps raise it
  float squares[lane_count] = {};           // [J] sums of A_ii step^2, of the impulses' steps
  float work[lane_count] = {};              // [J] sums of omega (bias - j v - softness * impulse) step
};

/// What a pass over all rows does to their impulses.
enum class LanePass {
  sweep,     // corrects them
  momentum,  // takes them further the way that they went since `before`, which they become
  weigh,     // nothing: the sum of squares is that of the corrections they all ask for now, as in R_E
};

/// The problem's numbers of one row of each block of a batch.
template <typename Real>
struct LaneInput {
  Real jacobian_a[3][lane_count];  // of the first body
  Real jacobian_b[3][lane_count];  // of the second body
  Real bias[lane_count];           // zeta (7)
  Real softness[lane_count];       // gamma [1/kg]
  Real impulse[lane_count];        // [N s]
  Real lower[lane_count];          // [N s]
  Real upper[lane_count];          // [N s]
  Real friction[lane_count];       // mu
};

/// The same of the bodies of a batch.
template <typename Real>
struct LaneBodyInput {
  Real velocity_a[3][lane_count];  // of the first bodies
  Real velocity_b[3][lane_count];  // of the second bodies
};

/// The roots of the inverse masses of the bodies of a batch.
struct LaneRoots {
  float a[3][lane_count];  // of the first bodies
  float b[3][lane_count];  // of the second bodies
};

/// What filling the lanes of a batch reads.
template <typename Real>
struct LaneFilling {
  LaneBodyInput<Real> bodies;            // of the blocks
  LaneRoots roots;                       // of the same
  LaneInput<Real> rows[most_lane_rows];  // the first row_count are in use
  int row_count = 0;                     // in each block
  Real relaxation = 1;                   // omega
};

}  // namespace cairn
