// What each kind of constraint writes in a step, and what its rows cost.
#include <fmt/format.h>

#include <set>

#include <cairn/collision/collide.hpp>
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "scenes.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

/// Does with a constraint what a step does, where the bodies of the stage are now: writes its rows.
using WriteRows = std::function<void(VelocityProblem<double>&)>;

struct ConstraintKind {
  std::string name = {};
  WriteRows write = {};
};

/// Where constraints are made and written: the ground and four bodies, with numbers of which none vanishes.
struct Stage {
  PerBody<Pose<double>> start = {{},
                                 {.position = {0.1, 0.2}, .angle = 0.3},
                                 {.position = {1.3, 0.4}, .angle = -0.2},
                                 {.position = {2.1, -0.3}, .angle = 0.5},
                                 {.position = {2.9, 0.6}, .angle = 0.1}};
  PerBody<Pose<double>> now = start;     // a little further: constraints have errors
  VelocityProblem<double> problem = {};  // without rows

  Stage() {
    problem.dt = 1.0 / 60;
    problem.inverse_mass = {{0, 0, 0}, {1, 1, 6}, {0.5, 0.5, 2}, {0.3, 0.3, 1}, {0.2, 0.2, 0.7}};
    problem.velocity = {{0, 0, 0}, {0.1, -0.2, 0.3}, {-0.3, 0.1, 0.2}, {0.2, 0.2, -0.1}, {0.1, 0.3, 0.1}};
    for (int i = 1; i < now.size(); ++i) {
      now[{i}].position += Vec2<double>(0.001, -0.002);
      now[{i}].angle += 0.003 * i;
    }
  }
};

const BodyId stage_a = {1};
const BodyId stage_b = {2};

template <typename Joint>
ConstraintKind joint_kind(const std::string& name, const typename Joint::Spec& spec) {
  const std::shared_ptr<const Constraint> joint = std::make_shared<const Joint>(spec, Stage().start);
  const Stage stage;
  const auto begin = std::make_shared<const BodyState<double>>(
      BodyState<double>{stage.now, stage.problem.velocity, stage.problem.inverse_mass});
  const RowRule<double> rule = joint_rule<double>({}, StabilizationPass::velocity, stage.problem.dt);
  return {name, [=](VelocityProblem<double>& problem) {
            int next = 0;
            problem.extra_terms.clear();
            const RowWriting<double> writing{.begin = *begin, .problem = problem, .next = next, .rule = rule};
            ProblemRows<double> rows(writing, 0);
            joint->write_rows(begin->pose, rows);
            problem.rows.resize(next);
          }};
}

/// A shape that lies on a box, by their manifold, which is found once.
ConstraintKind contact_kind(const std::string& name, const Shape<double>& upper, double friction,
                            FrictionRows friction_rows = FrictionRows::per_point) {
  PerBody<Pose<double>> poses = Stage().now;
  poses[{2}] = {.position = {0, 0}, .angle = 0};
  poses[{1}] = {.position = {0.1, 1}, .angle = 0};
  const Manifold<double> manifold = collide<double>(box(3, 1), poses[{2}], upper, poses[{1}], 0.02);
  const Contact<double> contact{.a = stage_b,
                                .b = stage_a,
                                .manifold = manifold,
                                .center_a = poses[stage_b].position,
                                .center_b = poses[stage_a].position,
                                .friction = friction};
  const RowRule<double> rule = contact_rule<double>({}, StabilizationPass::velocity, Stage().problem.dt, 10);
  return {name, [=](VelocityProblem<double>& problem) {
            problem.rule = rule;
            problem.friction_rows = friction_rows;
            int next = 0;
            write_contact_rows(contact, problem, next);
          }};
}

/// Joints on three and four bodies, and those that need no error of their own.
List<ConstraintKind> further_kinds() {
  const BodyId a = stage_a, b = stage_b, c{3}, d{4};
  const auto end = [](BodyId body, double x, double parts) {
    return PulleyJoint::End{.body = body, .anchor = {x, 0}, .roller = {x, 3}, .parts = parts};
  };
  const auto taut = PulleyJoint::Kind::taut;
  return {
      joint_kind<PulleyJoint>("pulley, 2 bodies", {.ends = {end(a, 0.1, 1), end(b, 1.3, 1)}, .kind = taut}),
      joint_kind<PulleyJoint>(
          "pulley, 4 bodies",
          {.ends = {end(a, 0.1, 1), end(b, 1.3, 2), end(c, 2.1, 2), end(d, 2.9, 1)}, .kind = taut}),
      joint_kind<GearJoint>("gear", {.a = a, .b = b, .radius_a = 0.5, .radius_b = 1.5}),
      joint_kind<DifferentialJoint>("differential", {.a = a, .b = b, .c = c}),
      joint_kind<DragJoint>("drag", {.body = b, .anchor = {1.2, 0.5}, .target = {2, 2}}),
      joint_kind<FrictionJoint>("friction from above, square",
                                {.b = b, .max_force = 3, .shape = FrictionShape::square}),
      joint_kind<FrictionJoint>("friction from above, circle", {.b = b, .max_force = 3}),
      joint_kind<FrictionJoint>("friction from above, turning too",
                                {.b = b, .max_force = 3, .max_torque = 2}),
  };
}

/// All kinds: a new one is one line here, or above.
List<ConstraintKind> all_kinds() {
  using Distance = DistanceJoint::Kind;
  const Vec2<double> p(0.6, 0.3), q(1.2, 0.5);  // [m] anchors
  const RevoluteJoint::Motor turn = {.speed = 1, .max_torque = 5};
  const PrismaticJoint::Motor slide = {.speed = 1, .max_force = 5};
  const SwingSoftness soft = {.frequency = 2, .damping_ratio = 0.5};
  const double near = 10;  // [m or rad] margin: within reach
  const BodyId a = stage_a, b = stage_b;
  List<ConstraintKind> kinds = {
      joint_kind<RevoluteJoint>("revolute", {.a = a, .b = b, .anchor = p}),
      joint_kind<RevoluteJoint>("revolute, limit far away", {.a = a, .b = b, .anchor = p, .lower = -2}),
      joint_kind<RevoluteJoint>(
          "revolute, limit, motor",
          {.a = a, .b = b, .anchor = p, .lower = -1, .limit_margin = near, .motor = turn}),
      joint_kind<PrismaticJoint>("prismatic", {.a = a, .b = b, .anchor = p, .axis = {1, 2}}),
      joint_kind<PrismaticJoint>(
          "prismatic, limit, motor",
          {.a = a, .b = b, .anchor = p, .axis = {1, 2}, .lower = -1, .limit_margin = near, .motor = slide}),
      joint_kind<DistanceJoint>("distance", {.a = a, .b = b, .anchor_a = p, .anchor_b = q}),
      joint_kind<DistanceJoint>("rope, taut",
                                {.a = a, .b = b, .anchor_a = p, .anchor_b = q, .kind = Distance::rope}),
      joint_kind<DistanceJoint>(
          "rope, slack", {.a = a, .b = b, .anchor_a = p, .anchor_b = q, .length = 5, .kind = Distance::rope}),
      joint_kind<DistanceJoint>(
          "spring",
          {.a = a, .b = b, .anchor_a = p, .anchor_b = q, .kind = Distance::spring, .softness = soft}),
      joint_kind<WeldJoint>("weld", {.a = a, .b = b, .anchor = p}),
      contact_kind("contact, 1 point, mu = 0", circle(0.5), 0),
      contact_kind("contact, 1 point", circle(0.5), 0.6),
      contact_kind("contact, 2 points, mu = 0", box(1, 1), 0),
      contact_kind("contact, 2 points", box(1, 1), 0.6),
      contact_kind("contact, 2 points, per manifold", box(1, 1), 0.6, FrictionRows::per_manifold),
  };
  const List<ConstraintKind> further = further_kinds();
  kinds.insert(kinds.end() - 5, further.begin(), further.end());  // contacts last
  return kinds;
}

VelocityProblem<double> problem_of_kind(const ConstraintKind& kind) {
  VelocityProblem<double> problem = Stage().problem;
  kind.write(problem);
  problem.impulse.assign(problem.rows.size(), 0);
  return problem;
}

/// So many constraints of a kind, each with bodies of its own.
VelocityProblem<double> repeated(const VelocityProblem<double>& one, int copies) {
  VelocityProblem<double> all;
  all.dt = one.dt;
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  for (int copy = 0; copy < copies; ++copy) {
    const int bodies = all.body_count(), rows = all.row_count(), extra = all.extra_terms.size();
    append(all.velocity, one.velocity);
    append(all.inverse_mass, one.inverse_mass);
    append(all.impulse, one.impulse);
    for (ConstraintRow<double> row : one.rows) {
      row.a.index += bodies;
      row.b.index += bodies;
      row.bounds.shift(rows);
      row.first_extra += extra;
      all.rows.push_back(row);
    }
    for (RowTerm<double> term : one.extra_terms) {
      term.body.index += bodies;
      all.extra_terms.push_back(term);
    }
  }
  return all;
}

Case write_case(const ConstraintKind& kind) {
  const int times = 2000;
  const auto problem = std::make_shared<VelocityProblem<double>>(Stage().problem);
  const auto run = [=](benchmark::State& state) {
    for (auto _ : state) {
      const Stopwatch stopwatch;
      for (int i = 0; i < times; ++i) {
        kind.write(*problem);
        benchmark::DoNotOptimize(problem->rows.data());
      }
      state.SetIterationTime(stopwatch.seconds() / times);
    }
  };
  return {.name = kind.name + "/write", .run = run, .iterations = 50, .repetitions = 21};
}

const int copies_to_sweep = 100;

/// Fifty sweeps of sequential impulses over many of the kind; the set-up is shared by all of them.
Case kind_sweep_case(const ConstraintKind& kind) {
  const int sweeps = 50;
  const auto start =
      std::make_shared<const VelocityProblem<double>>(repeated(problem_of_kind(kind), copies_to_sweep));
  const auto problem = std::make_shared<VelocityProblem<double>>(*start);
  const auto solver = std::make_shared<SequentialImpulse<double>>(SolverSettings{.iterations = sweeps});
  const auto run = [=](benchmark::State& state) {
    for (auto _ : state) {
      state.SetIterationTime(solve_seconds(*solver, *start, *problem) / sweeps);
    }
  };
  return {.name = kind.name + "/sweep", .run = run, .iterations = 100, .repetitions = 21};
}

/// "1 >= 0, 2 any": how many rows have which bounds.
std::string bounds_cell(const VelocityProblem<double>& problem) {
  std::map<std::string, int> counts;
  for (const ConstraintRow<double>& row : problem.rows) {
    const char* word = "at most F dt";
    if (row.bounds.is_equality()) word = "any";
    if (row.bounds.is_unilateral()) word = ">= 0";
    if (row.bounds.is_friction()) word = row.bounds.second_normal_row < 0 ? "mu N" : "mu (N + N)";
    if (row.bounds.disc > 0) word = "rest of a disc";
    counts[word] += 1;
  }
  std::string text;
  for (const auto& [word, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
  return text.empty() ? "-" : text;
}

std::size_t bodies_of(const VelocityProblem<double>& problem) {
  std::set<BodyId> bodies;
  for (const ConstraintRow<double>& row : problem.rows) {
    for_each_term(problem, row, [&](BodyId body, const Vec3<double>&) { bodies.insert(body); });
  }
  return bodies.size();
}

std::string softness_cell(const VelocityProblem<double>& problem) {
  const auto is_soft = [](const ConstraintRow<double>& row) { return row.softness > 0; };
  return std::any_of(problem.rows.begin(), problem.rows.end(), is_soft) ? "soft" : "rigid";
}

TextTable table_of_kinds(const List<ConstraintKind>& kinds, const std::map<std::string, Outcome>& outcomes) {
  TextTable table({{"constraint", ""},
                   {"bodies", ""},
                   {"rows", "updates/sweep"},
                   {"bounds", ""},
                   {"", ""},
                   {"writing", "ns/step"},
                   {"noise", ""},
                   {"a sweep", "ns"},
                   {"noise", ""}});
  for (const ConstraintKind& kind : kinds) {
    const VelocityProblem<double> problem = problem_of_kind(kind);
    const Times& write = outcomes.at(kind.name + "/write").time;
    const auto sweep = outcomes.find(kind.name + "/sweep");
    const bool is_swept = sweep != outcomes.end();
    table.add({kind.name, std::to_string(bodies_of(problem)), std::to_string(problem.row_count()),
               bounds_cell(problem), is_swept ? softness_cell(problem) : "-", three_digits(write.median),
               noise_cell(write), is_swept ? three_digits(sweep->second.time.median / copies_to_sweep) : "0",
               is_swept ? noise_cell(sweep->second.time) : "-"});
  }
  return table;
}

}  // namespace

void print_constraint_table() {
  print_heading("7. Constraints: what each kind writes, and what that costs");
  fmt::print(
      "Bounds of an impulse: any (an equality), >= 0 (a contact, a limit, a rope), mu N (friction on a\n"
      "normal impulse), at most F dt (a motor). Writing is done once a step: the rows, their bias and\n"
      "softness; without finding the contact. A sweep of sequential impulses updates every row once: its\n"
      "time is that of {} such constraints with bodies of their own, over {}, with a fiftieth of the\n"
      "set-up. A row in a sweep over so few rows finds them in the nearest cache.\n\n",
      copies_to_sweep, copies_to_sweep);
  const List<ConstraintKind> kinds = all_kinds();
  List<Case> cases;
  for (const ConstraintKind& kind : kinds) {
    cases.push_back(write_case(kind));
    if (!problem_of_kind(kind).rows.empty()) cases.push_back(kind_sweep_case(kind));
  }
  fmt::print("{}\n", table_of_kinds(kinds, measure(cases)).text());
}

}  // namespace cairn::bench
