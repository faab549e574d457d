// Which runs are hashed, and what of them.
#include "determinism/hash_list.hpp"

#include <sstream>

#include <cairn/study/frozen/frozen_set.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/contestant.hpp>

namespace cairn::determinism {

namespace {

const int hashed_steps = 60;

/// Contacts of all kinds, joints of all kinds, and scenes that are seen from above or fall apart.
const List<std::string>& hashed_scenes() {
  static const List<std::string> names = {
      "stack-offset", "arch", "bridge",  "chain-bob",    "cradle",  "differential", "gear-row",  "piston",
      "pulley",       "puck", "ragdoll", "rolling-disc", "tumbler", "weld-beam",    "spring-row"};
  return names;
}

const List<std::string>& hashed_solvers() {
  static const List<std::string> names = {"si", "pgs", "block-contact", "accelerated", "wide", "newton"};
  return names;
}

struct HashedScalar {
  const char* name = "";
  Precision precision = Precision::double_precision;
};
constexpr FixedList<HashedScalar, 2> hashed_scalars = {
    {{"float", Precision::single_precision}, {"double", Precision::double_precision}}};

std::uint64_t hash_of_run(const SceneEntry& entry, const std::string& solver, Precision precision) {
  Setting setting = entry.setting;
  setting.solver = solver;
  setting.scalar = precision;
  const std::unique_ptr<Contestant> contestant = make_contestant(entry.make(), setting);
  Fingerprint all;
  for (int step = 0; step < hashed_steps; ++step) {
    contestant->step();
    all.add(hexadecimal(fingerprint_of(contestant->snapshot())));
  }
  return all.value();
}

std::uint64_t hash_of_solve(VelocityProblem<double> problem, const std::string& solver) {
  make_solver<double>(solver)->solve(problem);
  Fingerprint all;
  for (const Vec3<double>& velocity : problem.velocity) all.add(velocity);
  for (const double impulse : problem.impulse) all.add(impulse);
  return all.value();
}

}  // namespace

int run_count() { return hashed_scenes().size() * hashed_solvers().size() * hashed_scalars.size(); }

std::string run_line(int run) {
  const HashedScalar& scalar = hashed_scalars[run % hashed_scalars.size()];
  const int pair = run / hashed_scalars.size();
  const std::string& solver = hashed_solvers()[pair % hashed_solvers().size()];
  const std::string& scene = hashed_scenes()[pair / hashed_solvers().size()];
  const std::uint64_t hash = hash_of_run(scene_entry(scene), solver, scalar.precision);
  return scene + " " + solver + " " + scalar.name + " " + hexadecimal(hash);
}

FrozenProblem written_and_read(const FrozenProblem& frozen) {
  std::stringstream text;
  write_frozen(text, frozen);
  return read_frozen(text, frozen.name);
}

List<std::string> frozen_lines(const List<FrozenProblem>& problems) {
  List<std::string> lines;
  for (const FrozenProblem& frozen : problems) {
    for (const std::string& solver : hashed_solvers()) {
      lines.push_back("frozen " + frozen.name + " " + solver + " " +
                      hexadecimal(hash_of_solve(frozen.problem, solver)));
    }
  }
  return lines;
}

List<std::string> all_lines() {
  List<std::string> lines;
  for (int run = 0; run < run_count(); ++run) lines.push_back(run_line(run));
  List<FrozenProblem> problems;
  for (const std::string& name : frozen_names()) problems.push_back(make_frozen(name));
  const List<std::string> frozen = frozen_lines(problems);
  lines.insert(lines.end(), frozen.begin(), frozen.end());
  return lines;
}

}  // namespace cairn::determinism
