// Where the time of a step goes, for each contact point.
#include <fmt/format.h>

#include <cstdio>

#include "../table.hpp"
#include "peer_tables.hpp"

namespace cairn::bench {

namespace {

void add_phases(const std::string& engine, const Phases& phases, int points, TextTable& table) {
  double all = 0;
  for (const Phase& phase : phases.parts) {
    const double nanoseconds = 1e9 * times_of(phase.seconds).median / points;
    table.add({engine + ": " + phase.name, three_digits(nanoseconds)});
    all += nanoseconds;
  }
  table.add({engine + ": whole step", three_digits(all)});
}

}  // namespace

void print_phases(const List<PeerScene>& scenes, const RunLength& length) {
  print_heading("3. Where the time of a step goes");
  fmt::print(
      "Medians of all steps, for each contact point that Cairn finds in a step on average. Cairn is seen\n"
      "from outside, by a solver that takes its own time; Box2D 3 tells its profile, which is by the clock\n"
      "on the wall: on a busy machine that of other programs is in it.\n\n");
  for (const PeerScene& entry : scenes) {
    const Task task(entry, length);
    const Scene& scene = task.scene;
    if (!scene.joints().empty()) continue;
    const Setting si = {.solver = "si", .sweeps = {.iterations = 10}};
    const Phases of_cairn = phases_of_cairn(scene, si, task.length.steps);
    TextTable table({{entry.name, fmt::format("{} points", grouped(of_cairn.points))}, {"a point", "ns"}});
    add_phases("Cairn si x10", of_cairn, of_cairn.points, table);
#ifdef CAIRN_PEER_BOX2D_3
    add_phases("Box2D 3", phases_of_box2d_3(scene, {.substeps = 4}, task.length.steps), of_cairn.points,
               table);
#endif
    fmt::print("{}\n", table.text());
    std::fflush(stdout);
  }
}

}  // namespace cairn::bench
