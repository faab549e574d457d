// cairn explain: what a scene makes the engine do, and what it leaves out.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;
using Counts = std::map<std::string, int>;

constexpr int most_rows_of_reference = 60;  // above, its exact answer takes too long for a glance

/// What is counted in a scene before and after its first step.
struct SceneCounts {
  Counts bodies = {}, shapes = {}, joints = {};
  List<SceneEvent> events = {};
  int apart = 0;  // pairs of bodies that a joint keeps from colliding
  int contacts = 0, rows = 0, equalities = 0, normals = 0, frictions = 0;
  std::size_t problem_bytes = 0;
};

/// What a solver keeps beside the problem, or why that is not known.
struct SolverMemory {
  std::string solver = {};
  std::size_t bytes = 0;
  std::string unknown = {};
};

/// "2, the first at 0.5 s, the last at 2 s; 3 of touches".
std::string events_text(const List<SceneEvent>& events) {
  List<double> times;
  for (const SceneEvent& event : events) {
    if (!event.touch) times.push_back(event.time);
  }
  const int touches = events.size() - times.size();
  std::string text;
  if (times.size() == 1) text = fmt::format("1, at {:g} s", times.front());
  if (times.size() > 1)
    text =
        fmt::format("{}, the first at {:g} s, the last at {:g} s", times.size(), times.front(), times.back());
  if (touches > 0) text += fmt::format("{}{} of touches", text.empty() ? "" : "; ", touches);
  return text;
}

SceneCounts counts_of(const Scene& scene, const World<double>& after, int contacts) {
  SceneCounts counts;
  for (const SceneBody& body : scene.bodies()) {
    if (body.removed) continue;
    counts.bodies[word_of(body.spec.type)] += 1;
    for (const Shape<double>& shape : body.spec.shapes) counts.shapes[shape_name(shape)] += 1;
  }
  for (const auto& joint : scene.joints()) counts.joints[joint->name()] += 1;
  const VelocityProblem<double> problem = with_rows(after).problem;
  for (const ConstraintRow<double>& row : problem.rows) {
    int& kind = row.bounds.is_friction()     ? counts.frictions
                : row.bounds.is_unilateral() ? counts.normals
                                             : counts.equalities;
    kind += 1;
  }
  counts.events = scene.events();
  counts.apart = scene.joints().apart().size();
  counts.contacts = contacts;
  counts.rows = problem.row_count();
  counts.problem_bytes = problem.rows.bytes() + problem.blocks.bytes() + problem.extra_terms.bytes() +
                         problem.inverse_mass.bytes() + problem.velocity.bytes() + problem.impulse.bytes();
  return counts;
}

List<SolverMemory> memories_of(const VelocityProblem<double>& problem) {
  List<SolverMemory> memories;
  for (const SolverEntry& entry : solver_entries()) {
    SolverMemory memory{.solver = entry.name};
    if (entry.name == "reference" && problem.row_count() > most_rows_of_reference) {
      memory.unknown =
          fmt::format("not tried with more than {} rows: it takes m^3 work", most_rows_of_reference);
    } else {
      try {
        const auto solver = make_solver<double>(entry.name, {.iterations = 1});
        VelocityProblem<double> copy = problem;
        solver->solve(copy);
        memory.bytes = solver->memory();
      } catch (const std::logic_error& refusal) {
        memory.unknown = std::string("refuses: ") + refusal.what();
      }
    }
    memories.push_back(memory);
  }
  return memories;
}

std::string counts_text(const Counts& counts) {
  List<std::string> parts;
  for (const auto& [name, count] : counts) parts.push_back(fmt::format("{} {}", count, name));
  return parts.empty() ? "none" : joined(parts, ", ");
}

std::string bytes_text(std::size_t bytes) {
  const double value = static_cast<double>(bytes);
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  return value < 1048576 ? fmt::format("{:.1f} KiB", value / 1024)
                         : fmt::format("{:.1f} MiB", value / 1048576);
}

/// Joined bodies go through each other, which is easily overlooked where one of them is the ground.
std::string apart_text(const SceneEntry& entry, int count) {
  const int most = 3;  // pairs that are named
  List<std::string> pairs;
  const Scene scene = entry.make();
  for (int i = 0; i < std::min(count, most); ++i) {
    const auto& [a, b] = scene.joints().apart()[i];
    pairs.push_back(entry.body_names[a] + " and " + entry.body_names[b]);
  }
  const std::string rest = count > most ? fmt::format(", and {} pairs more", count - most) : "";
  return fmt::format("joined bodies do not collide: {}{}", joined(pairs, ", "), rest);
}

void print_explanation(const SceneEntry& entry, const Setting& setting, const Plan& plan,
                       const SceneCounts& counts, const List<SolverMemory>& memories, Console& console) {
  const auto line = [&console](const std::string& name, const std::string& what) {
    console.result(console.spelt("  " + padded(name, 14) + what));
  };
  console.result(console.spelt(entry.name + ": " + entry.title));
  console.result(console.spelt(entry.look));
  line("setting", setting_text(setting));
  if (const std::string why = why_chosen(entry, setting); !why.empty()) line("chosen", why);
  line("lengths", plan.lengths);
  std::string text = explain(plan);
  if (!text.empty() && text.back() == '\n') text.pop_back();
  console.result(console.spelt(text));
  console.result("It has");
  line("bodies", counts_text(counts.bodies));
  line("shapes", counts_text(counts.shapes));
  line("joints", counts_text(counts.joints));
  if (!counts.events.empty()) line("events", events_text(counts.events));
  if (counts.apart > 0) line("apart", apart_text(entry, counts.apart));
  console.result("Its first step has");
  line("contacts", fmt::format("{} points", counts.contacts));
  line("rows", fmt::format("{}: {} of joints and motors, {} one-sided, {} of friction", counts.rows,
                           counts.equalities, counts.normals, counts.frictions));
  line("problem", bytes_text(counts.problem_bytes));
  console.result("and keeps beside it, in double");
  for (const SolverMemory& memory : memories) {
    const std::string how_much = memory.unknown.empty() ? bytes_text(memory.bytes) : memory.unknown;
    console.result(console.spelt("  " + padded(memory.solver, 18) + how_much));
  }
}

Json explanation_json(const SceneEntry& entry, const Setting& setting, const Plan& plan,
                      const SceneCounts& counts, const List<SolverMemory>& memories) {
  Json memory = Json::object();
  for (const SolverMemory& one : memories)
    memory[one.solver] = one.unknown.empty() ? Json(one.bytes) : Json(nullptr);
  return {{"scene", entry.name},
          {"title", entry.title},
          {"setting", setting_text(setting)},
          {"bodies", counts.bodies},
          {"shapes", counts.shapes},
          {"joints", counts.joints},
          {"events", counts.events.size()},
          {"pairs_apart", counts.apart},
          {"velocities", 2 * plan.size.dynamic_bodies + plan.size.turning_bodies},
          {"collision", plan.collision},
          {"gravity", plan.gravity},
          {"friction", plan.friction},
          {"restitution", plan.restitution},
          {"damping", plan.damping},
          {"warm_start", plan.settings.warm_start},
          {"substeps", plan.settings.substeps},
          {"sleeping", plan.settings.sleeping.has_value()},
          {"unit_length_m", plan.length},
          {"speculative_margin_m", *plan.settings.speculative_margin},
          {"slop_m", *plan.settings.stabilization.slop},
          {"max_speed_m_s", *plan.settings.stabilization.max_speed},
          {"restitution_threshold_m_s", *plan.settings.restitution_threshold},
          {"contacts", counts.contacts},
          {"rows", counts.rows},
          {"rows_of_joints", counts.equalities},
          {"rows_one_sided", counts.normals},
          {"rows_of_friction", counts.frictions},
          {"problem_bytes", counts.problem_bytes},
          {"solver_bytes", memory}};
}

int run_explain(const Words& words, Console& console) {
  const SceneEntry entry = scene_of(words, words.places.front());
  const Setting setting = setting_of(words, entry);
  Scene scene = entry.make();
  scene.set_settings(with_setting(scene.settings(), setting));
  World<double> world(scene);
  const VelocityProblem<double> problem = world.velocity_problem();
  const auto solver = make_solver<double>("si", setting.sweeps);
  const StepReport report = world.step(*solver);
  const SceneCounts counts = counts_of(scene, world, report.contacts);
  const List<SolverMemory> memories = memories_of(problem);
  if (words.has("json")) {
    fmt::print("{}\n", explanation_json(entry, setting, make_plan(world.scene()), counts, memories).dump(1));
  } else {
    print_explanation(entry, setting, make_plan(world.scene()), counts, memories, console);
  }
  return all_well;
}

}  // namespace

Verb explain_verb() {
  return {
      .name = "explain",
      .places = "SCENE",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "what is modelled and what left out, and the cost in rows and memory",
      .idea =
          "A scene pays only for what it has: without friction there are no friction rows, without gravity "
          "none is added. This verb says what the scene needs, what the step leaves out and why, how many "
          "rows its first step has, and how much memory each solver wants for them.",
      .flags = setting_flags(),
      .examples = {"explain arch", "explain chain --stabilization split-impulse", "explain puck --json"},
      .run = run_explain};
}

}  // namespace cairn::sandbox
