// Floor 9. One solver on one frozen problem: how far it comes with so many sweeps, and in what time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <cairn/measure/truth.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/scenes/setting.hpp>

namespace cairn {

enum class Start { cold, warm };  // without impulses, or from those of the problem

struct SolveChoice {
  std::string solver = "si";  // a name of solver_entries()
  int sweeps = 10;
  Precision scalar = Precision::double_precision;
  Start start = Start::warm;
};

/// How long solving is repeated: until both are reached. With repetitions 0 nothing is timed.
struct SolveTiming {
  int repetitions = 30;
  double seconds = 0.05;
};

/// [ns] of processor time of one solve.
struct SolveTimes {
  int repetitions = 0;
  double least = 0;
  double median = 0;
  double quartile_range = 0;
  /// Above a tenth the machine had other work: nothing should be made of the median.
  double spread() const { return median > 0 ? quartile_range / median : 0; }
};

struct SolveOutcome {
  /// "ok", "plateau", "cycle", "nan" or "refused". Stopping (solvers/stopping.hpp) says what cycles and
  /// plateaus are; a solved problem whose last bits go round in a circle is a cycle too.
  std::string status = {};
  std::string reason = {};  // of a refusal
  AnswerError<double> error = {};
  std::int64_t row_updates = 0;
  SolveTimes times = {};
  std::uint64_t state_hash = 0;  // FNV-1a of the velocities
};

/// `truth`: v* where it is unique. The error is judged in double, whatever the solver computes in.
SolveOutcome try_solver(const VelocityProblem<double>& problem, const SolveChoice& choice,
                        const std::optional<PerBody<Vec3<double>>>& truth, const SolveTiming& timing);

}  // namespace cairn
