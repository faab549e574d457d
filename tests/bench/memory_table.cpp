// What solvers store, against the number of rows (paper 4.4, eq. (30)).
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "scenes.hpp"
#include "table.hpp"
#include "tables.hpp"
#include <cairn/samples/samples.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn::bench {

namespace {

/// The dense solver would take seconds to multiply J M^-1 J^T beyond this, to store what is known by then.
const int largest_dense = 1700;

/// What one scene of a family takes.
struct MemoryOfScene {
  double rows = 0;
  List<std::optional<double>> bytes = {};  // of each solver
};

template <typename SolverType>
std::optional<double> bytes_kept(VelocityProblem<double> problem) {
  const bool dense = std::is_same_v<SolverType, ProjectedGaussSeidel<double>>;
  if (dense && problem.row_count() > largest_dense) return std::nullopt;
  SolverType solver({.iterations = 1});
  solver.solve(problem);
  return static_cast<double>(solver.memory());
}

MemoryOfScene memory_of_scene(const VelocityProblem<double>& problem) {
  return {.rows = static_cast<double>(problem.row_count()),
          .bytes = {bytes_kept<ProjectedGaussSeidel<double>>(problem),
                    bytes_kept<SparseProjectedGaussSeidel<double>>(problem),
                    bytes_kept<FactoredProjectedGaussSeidel<double>>(problem),
                    bytes_kept<AcceleratedProjectedGaussSeidel<double>>(problem),
                    bytes_kept<Jacobi<double>>(problem), bytes_kept<SequentialImpulse<double>>(problem)}};
}

std::string count_with_share(std::ptrdiff_t count, double rows) {
  return fmt::format("{} ({:.1f} m)", grouped(count), static_cast<double>(count) / rows);
}

/// The p of bytes ~ m^p between the two largest scenes that have a number.
std::string growth_cell(const List<MemoryOfScene>& scenes, int solver) {
  const MemoryOfScene* larger = nullptr;
  for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene) {
    if (!scene->bytes[solver]) continue;
    if (larger != nullptr) {
      return fmt::format("m^{:.2f}", std::log(*larger->bytes[solver] / *scene->bytes[solver]) /
                                         std::log(larger->rows / scene->rows));
    }
    larger = &*scene;
  }
  return "-";
}

void print_family(const std::string& name, const std::function<VelocityProblem<double>(int)>& make,
                  const List<int>& sizes) {
  TextTable counts({{name, "size"},
                    {"m", "rows"},
                    {"A dense: m^2", "entries"},
                    {"(30) as printed", "entries (a row)"},
                    {"not zero in A", "entries (a row)"},
                    {"on one body", "entries (a row)"}});
  TextTable stored({{name, "m"},
                    {"PGS dense", "bytes/row"},
                    {"PGS sparse", "bytes/row"},
                    {"PGS factored", "bytes/row"},
                    {"accelerated", "bytes/row"},
                    {"Jacobi", "bytes/row"},
                    {"SI", "bytes/row"}});
  List<MemoryOfScene> scenes;
  for (const int size : sizes) {
    const VelocityProblem<double> problem = cold(make(size));
    scenes.push_back(memory_of_scene(problem));
    const double m = scenes.back().rows;
    const std::ptrdiff_t rows = problem.row_count();
    counts.add({std::to_string(size), grouped(rows), grouped(rows * rows),
                count_with_share(non_zeros_as_printed(problem), m), count_with_share(non_zeros(problem), m),
                count_with_share(coupled_pairs(problem), m)});
    List<std::string> cells = {grouped(rows)};
    for (const auto& bytes : scenes.back().bytes) {
      cells.push_back(bytes ? fmt::format("{:.1f}", *bytes / m) : "-");
    }
    stored.add(cells);
  }
  List<std::string> growth = {"all bytes grow as"};
  for (int solver = 0; solver < scenes.front().bytes.size(); ++solver) {
    growth.push_back(growth_cell(scenes, solver));
  }
  stored.add(growth);
  fmt::print("{}\n{}\n", counts.text(), stored.text());
}

/// What a world keeps after some steps, with the scene that it was made from.
struct WorldMemory {
  int bodies = 0;
  int points = 0;       // of contacts
  double of_scene = 0;  // [bytes]
  double bytes = 0;     // with the scene
};

template <typename SolverType = SequentialImpulse<double>>
WorldMemory world_memory(const std::function<Scene()>& make) {
  const double before = heap_in_use();
  Scene scene = make();
  const double of_scene = heap_in_use() - before;
  World<double> world(std::move(scene));
  StepReport report;
  {
    SolverType solver;  // the memory of solvers is in the tables above
    for (int step = 0; step < 10; ++step) report = world.step(solver);
  }
  return {world.scene().bodies().size() - 1, report.contacts, of_scene, heap_in_use() - before};
}

Scene boxes_in_the_air() {
  Scene scene;
  samples::add_line(scene, 1000, {.shapes = {box(1, 1)}}, {2, 0});
  return scene;
}

/// What a body costs is seen where nothing touches; what a pyramid keeps beyond that is its contacts'.
void print_world_memory() {
  const WorldMemory air = world_memory(boxes_in_the_air);
  const double of_body = air.bytes / air.bodies;
  TextTable table({{"world", ""},
                   {"bodies", ""},
                   {"contact points", ""},
                   {"kept", "kB"},
                   {"its scene", "kB"},
                   {"of a body", "bytes"},
                   {"of a contact point", "bytes"}});
  table.add({"boxes in the air", grouped(air.bodies), "0", grouped(std::lround(air.bytes / 1024)),
             grouped(std::lround(air.of_scene / 1024)), grouped(std::lround(of_body)), "-"});
  const auto add = [&](const std::string& name, const WorldMemory& pyramid) {
    const double of_point = (pyramid.bytes - of_body * pyramid.bodies) / pyramid.points;
    table.add({name, grouped(pyramid.bodies), grouped(pyramid.points),
               grouped(std::lround(pyramid.bytes / 1024)), grouped(std::lround(pyramid.of_scene / 1024)), "",
               grouped(std::lround(of_point))});
  };
  const auto pyramid = [](int base) {
    return [base] {
      Scene scene;
      cases::add_pyramid(scene, base);
      return scene;
    };
  };
  for (const int base : {10, 20, 40}) {
    add(fmt::format("pyramid of base {}", base), world_memory(pyramid(base)));
  }
  add("the same in lanes", world_memory<WideSequentialImpulse<double>>(pyramid(40)));  // which need no rows
  fmt::print(
      "What a World keeps, with its scene, which worlds made of the same one share, and with what the\n"
      "allocator has set aside for more:\n{}\n",
      table.text());
}

}  // namespace

void print_memory_table() {
  print_heading("3. Memory: what is stored, against the number of rows m");
  fmt::print(
      "Paper 4.4: the m x m matrix of PGS does not scale well, its non-zeros (30) do better, and SI stores "
      "one\n"
      "effective mass a row: 8 bytes, linear in m. Eq. (30) as printed has J_i . J_j where A has\n"
      "J_i M^-1 J_j^T, so that it counts pairs that meet only on the ground. Some pairs of rows on one body "
      "that\n"
      "can move cancel by symmetry; a sparse A keeps a place for them. Bytes are what solvers keep beside "
      "the\n"
      "problem; growth is between the two largest scenes. \"-\": not tried.\n\n");
  print_family("pyramid", pyramid_problem, {5, 10, 20, 40});
  print_family("stack", stack_problem, {25, 50, 100, 200, 400});
  print_family("chain", chain_problem, {50, 100, 200, 400, 800});
  print_world_memory();
}

}  // namespace cairn::bench
