// Floor 4. A velocity problem in lanes, and back.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/wide/lane_batches.hpp>
#include <cairn/solvers/wide/lane_contacts.hpp>
#include <cairn/solvers/wide/lane_momentum.hpp>
#include <cairn/solvers/wide/lane_sets.hpp>

namespace cairn {

/// The steps that impulses took in one pass over all rows.
template <Scalar Real>
struct LaneSteps {
  Real largest = 0;  // [N s]
  Real squares = 0;  // [J] sum of A_ii step^2
  Real work = 0;     // [J] sum of omega (bias - j v - softness * impulse) step

  /// Those of other rows.
  void add(const LaneSteps& other) {
    largest = largest < other.largest ? other.largest : largest;
    squares += other.squares;
    work += other.work;
  }
};

/// How to look at an answer.
enum class LaneLook { rough, exact };

/// The rows of a problem in lanes, and those that fit into none. Lanes compute in single precision; but
/// all that they hold are changes since the problem was taken over,
/// whose numbers stay in its own precision. So what is lost is a part of a change, and taking over the
/// problem again, with these changes in it, loses nothing but a part of the next ones.
template <Scalar Real>
class LaneSystem {
 public:
  /// @throws std::invalid_argument for a set that this processor has not.
  LaneSystem(LaneSet set, Real relaxation);

  /// Lays a problem in lanes, with rows of contacts or without, and gives it its warm start, in the order of
  /// a sweep.
  void begin(VelocityProblem<Real>& problem);
  /// Takes over a problem that has begun; changes begin at 0.
  void take(const VelocityProblem<Real>& problem);
  /// One sweep. A watcher sees the problem after each row, once all rows of its batch have been updated;
  /// null: nobody does.
  LaneSteps<Real> sweep(VelocityProblem<Real>& problem, int number, SolveObserver<Real>* watcher);
  /// The only sweep over a problem that has begun: nothing is taken to lanes for the next one. In the
  /// problem's own precision, row by row, and contacts that have none a batch at a time. An observer sees the
  /// problem after each row; null: nobody does. Returns the largest step of an impulse [N s].
  Real sweep_once(VelocityProblem<Real>& problem, int number, SolveObserver<Real>* observer);
  /// Remembers where impulses and velocities are, and takes impulses another `momentum` times the way that
  /// they went since remembered last, inside their bounds. After take() and undo() there is no such way:
  /// `momentum` must be 0.
  LaneSteps<Real> gather_momentum(VelocityProblem<Real>& problem, Real momentum);
  /// Goes back to where gather_momentum() began.
  void undo(VelocityProblem<Real>& problem);
  /// Writes back, and takes over what was written; what is remembered stays.
  void take_again(VelocityProblem<Real>& problem);
  /// Writes impulses, inside their bounds, and the velocities that they make.
  void write_back(VelocityProblem<Real>& problem);
  /// The scale of R_E, as residual_scale(), once the problem has begun; but added up in the order of lanes.
  Real residual_scale(VelocityProblem<Real>& problem);
  /// R_E, added up in the order of lanes: of what was written back last, as residual(); or of what lanes hold
  /// now, with their roundings, which reads less than to write it back.
  Real residual(VelocityProblem<Real>& problem, Real scale, LaneLook look);
  /// Whether a change so small [N s], the last of many that add up to `path`, is lost in the rounding of
  /// lanes but would not be in that of the problem.
  bool is_worth_taking(Real change, Real path) const;
  /// What it takes up [bytes].
  std::size_t bytes() const;

 private:
  // Sums over so many are made in the lanes' precision, in which those of many more would lose their small
  // terms.
  static constexpr int batches_in_a_sum = 16;

  /// The problem as it was taken over.
  struct TakenOver {
    PerBody<Vec3<Real>> inverse_mass;
    PerBody<Vec3<Real>> root;  // of the inverse masses
    PerBody<Vec3<Real>> velocity;
    PerRow<Real> impulse;  // [N s]
  };
  /// Of the rows that go one by one.
  struct Singles {
    List<ConstraintRow<Real>> contact_rows;  // of contacts without rows
    List<Real> mass;                         // [kg] 1 / A_ii
  };

  template <typename OfRows, typename OfContacts>
  void for_each_run(const OfRows& of_rows, const OfContacts& of_contacts) const;
  bool push_rows(VelocityProblem<Real>& problem);
  void push(VelocityProblem<Real>& problem);
  void begin_rows(VelocityProblem<Real>& problem);
  void write_single_contacts(VelocityProblem<Real>& problem);
  const ConstraintRow<Real>& single_row(const VelocityProblem<Real>& problem, int k) const;
  void begin_changes(const VelocityProblem<Real>& problem);
  void fill(const VelocityProblem<Real>& problem);
  void empty_rows(VelocityProblem<Real>& problem, const LaneBatch& batch) const;
  void empty_single_rows(VelocityProblem<Real>& problem) const;
  bool take_masses(const VelocityProblem<Real>& problem);
  void take_single_rows(const VelocityProblem<Real>& problem);
  void take_batch_bodies(const LaneBatch& batch);
  void take_row(const VelocityProblem<Real>& problem, const LaneBatch& batch, int number, int lane);
  template <LanePass kind>
  LaneSteps<Real> pass(VelocityProblem<Real>& problem, int number = 0,
                       SolveObserver<Real>* watcher = nullptr);
  template <LanePass kind>
  LaneSteps<Real> pass_single_rows(VelocityProblem<Real>& problem, int number, SolveObserver<Real>* watcher);
  Real single_row_velocity(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) const;
  void apply_single_row(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real step);
  template <LanePass kind>
  LaneSteps<Real> pass_batches(VelocityProblem<Real>& problem, int first, int last, int number,
                               SolveObserver<Real>* watcher);
  void watch_batch(int number, const LaneBatch& batch, VelocityProblem<Real>& problem,
                   SolveObserver<Real>& observer) const;
  Real energy(const VelocityProblem<Real>& problem, LaneEnergy kind);
  Real written_back(const VelocityProblem<Real>& problem, const LaneBatch& batch, int row, int lane) const;
  LaneProblem lane_problem();

  LaneCode<Real> code_;
  Real relaxation_;  // omega
  LaneBatches batches_;
  LaneContacts<Real> contacts_;  // without rows
  List<LaneRow> rows_;
  List<LaneCoupling> couplings_;
  PerBody<LaneBody<float>> bodies_;  // and one that nothing moves
  TakenOver from_;
  Singles single_;
  LaneMomentum<Real> before_;
  LaneFilling<Real> filling_ = {};  // scratch, for one batch
};

/// The k-th of those that go one by one: contacts come last.
template <Scalar Real>
const ConstraintRow<Real>& LaneSystem<Real>::single_row(const VelocityProblem<Real>& problem, int k) const {
  const int of_contacts = k - (batches_.singles().rows.size() - single_.contact_rows.size());
  return of_contacts < 0 ? problem.rows[batches_.singles().rows[k]] : single_.contact_rows[of_contacts];
}

/// Calls of_rows(batch) for a batch whose blocks have rows and of_contacts(run) for batches of contacts
/// without rows that follow each other, in the order of batches.
template <Scalar Real>
template <typename OfRows, typename OfContacts>
void LaneSystem<Real>::for_each_run(const OfRows& of_rows, const OfContacts& of_contacts) const {
  const List<LaneBatch>& all = batches_.batches();
  for (int first = 0, last = 0; first < all.size(); first = last) {
    last = first + 1;
    if (all[first].contacts < 0) {
      of_rows(all[first]);
      continue;
    }
    while (last < all.size() && all[last].contacts >= 0) ++last;
    of_contacts(Span<const LaneBatch>(all.data() + first, last - first));
  }
}

}  // namespace cairn
