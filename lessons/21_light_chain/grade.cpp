// Exercise 21, graded: two beads of which one is heavy enough, one bead at another step, and a chain in
// swing.
#include "exercise.cpp"

namespace cairn::exercise21 {
namespace {

/// A chain, and which of its beads is asked for.
struct Case {
  const char* name = "";
  List<double> force = {};
  List<double> length = {};
  List<double> mass = {};
  double dt = 0;
};

const Case two{
    .name = "two beads", .force = {30, 25, 20}, .length = {0.5, 0.25, 0.4}, .mass = {0.001, 0.5}, .dt = 0.02};
const Case one{.name = "one bead", .force = {8, 12}, .length = {2, 0.5}, .mass = {0.001}, .dt = 0.05};

void grade_bead(Grade& grade, const Case& each, int i, const std::string& what) {
  const double above = each.force[i] / each.length[i], below = each.force[i + 1] / each.length[i + 1];
  const double k = above + below, share = each.dt * each.dt / 2, own = each.mass[i];
  const double products = each.force[i] * each.length[i] + each.force[i + 1] * each.length[i + 1];
  const double joined = (each.force[i] + each.force[i + 1]) / (each.length[i] + each.length[i + 1]);
  List<double> mass = each.mass;
  raise_masses(each.force, each.length, mass, each.dt);
  const auto raised = [own](double least) { return std::max(own, least); };
  grade.number(
      {.what = std::string(each.name) + what,
       .value = raised(share * k),
       .misconceptions = {{share * k,
                           "A bead that is heavy enough is never lighter: take the larger of both."},
                          {own, "The bead stays as light as it was."},
                          {raised(each.dt * k / 2), "Δt enters twice: (ω Δt)² is at most 4."},
                          {raised(2 * share * k), "That holds, but it is twice what is needed."},
                          {raised(share * k / 2),
                           "That is ω² = k / m, of a bead alone: neighbours swing against it."},
                          {raised(share * above), "That is one rod: the rod below pulls, too."},
                          {raised(share * below), "That is one rod: the rod above pulls, too."},
                          {raised(share * products), "A short rod turns more: divide by the length."},
                          {raised(share * joined), "Each rod is a spring of its own: add f / l."},
                          {own + share * k, "It takes part with this mass, not in addition to its own."},
                          {raised(k / 2), "That is N/m: a stiffness is no mass without Δt²."}}},
      mass[i]);
}

/// Ten beads of 0.1 kg under 50 kg, 1 mm to the left and to the right in turn, with the masses of the reader:
/// how many are 0.1 m off after 60 steps of 0.02 s. Nail and load stay where they are.
int beads_lost() {
  constexpr int beads = 10, steps = 60;
  constexpr double length = 0.5, dt = 0.02;
  List<double> force, mass(beads, 0.1), x(beads + 2, 0), v(beads + 2, 0);
  for (int i = 0; i <= beads; ++i) force.push_back((50 + 0.1 * (beads - i)) * 10);
  raise_masses(force, List<double>(beads + 1, length), mass, dt);
  for (int i = 1; i <= beads; ++i) x[i] = i % 2 == 1 ? 0.001 : -0.001;
  for (int k = 0; k < steps; ++k) {
    for (int i = 1; i <= beads; ++i)
      v[i] += dt / mass[i - 1] * (force[i - 1] * (x[i - 1] - x[i]) + force[i] * (x[i + 1] - x[i])) / length;
    for (int i = 1; i <= beads; ++i) x[i] += dt * v[i];
  }
  return static_cast<int>(std::count_if(x.begin(), x.end(), [](double at) { return !(std::abs(at) < 0.1); }));
}

void grade(Grade& grade) {
  grade_bead(grade, two, 0, ": the light one (kg)");
  grade_bead(grade, two, 1, ": the heavy one (kg)");
  grade_bead(grade, one, 0, ", Δt = 0.05 s (kg)");
  grade.number({.what = "50 kg on ten beads, 60 steps: beads lost", .value = 0}, beads_lost());
}

}  // namespace

Exercise exercise() {
  return {.lesson = 21,
          .task = "The least masses with which no swing of a chain has ω Δt above 2.",
          .file = "lessons/21_light_chain/exercise.cpp",
          .hints = {"How stiff are both rods together, sideways?",
                    "If a bead goes right and both neighbours go left, its rods pull twice as hard: ω² is up "
                    "to 2 k / m.",
                    "(ω Δt)² <= 4 makes m at least Δt² k / 2. Keep the larger of that and what it has."},
          .grade = grade};
}

}  // namespace cairn::exercise21
