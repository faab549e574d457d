// Lesson 12. What is printed, and what is checked.
#include "lesson.hpp"

#include <Eigen/Cholesky>

namespace cairn::blocks {

namespace {

const double epsilon = 2.3e-16;

void print_rod(Lesson& lesson, const BlocksRuns& all) {
  const RodRun& rod = all.rod;
  const Matrix<double>& A = rod.system.A;
  lesson.print(
      fmt::format("Rod, its pin.  A = [{:.4g} {:.4g}; {:.4g} {:.4g}] 1/kg,  b = ({:.4g}, {:.4g}) m/s²,  from "
                  "λ = ({:g}, {:g}) N",
                  A(0, 0), A(0, 1), A(1, 0), A(1, 1), rod.system.b(0) + 0.0, rod.system.b(1),
                  rod.by_rows[0][0], rod.by_rows[0][1]));
  lesson.print("  sweep row      j·v    Δλ (N), (22)       λ₁        λ₂ (N)   pinned end moves at (m/s)");
  for (int i = 0; i < rod.updates.size(); ++i) {
    const RodUpdate& update = rod.updates[i];
    const std::string line =
        fmt::format("  {:>5} {:>3} {:>8.4f} {:>+15.4f} {:>8.4f} {:>9.4f}   ({:>7.4f}, {:>7.4f})",
                    update.sweep, update.row + 1, update.jv, update.corrective, update.after[0],
                    update.after[1], cleaned(update.slip.x()), cleaned(update.slip.y()));
    lesson.print_if(i < 6, line);
  }
  lesson.print(fmt::format("  the block, sweep 1:        A⁻¹ b = {:>8.4f} {:>9.4f}   ( 0,       0     )",
                           rod.by_block[1][0], rod.by_block[1][1]));
  lesson.print();
}

void print_chains(Lesson& lesson, const BlocksRuns& all) {
  lesson.print(
      "Beams: sweeps until no λ (N, N m) is wrong by more than 1 % of the largest, and multiply-adds for "
      "them");
  lesson.print("                               rows   blocks    left (%)    work of blocks / rows");
  for (const ChainRun& chain : all.chains) {
    const double ratio = static_cast<double>(chain.blocks.work) / static_cast<double>(chain.rows.work);
    lesson.print(fmt::format("  {:<26} {:>6} {:>8} {:>11.0f} {:>16.2f}", chain.name, chain.rows.sweeps,
                             chain.blocks.sweeps, share_left(chain), ratio));
  }
  const ChainRun& three = all.chains[welded_three];
  lesson.print(fmt::format("  {:<26} {:>6} {:>8} {:>11.0f}", "3 beams, √(eᵀ A e) to 1 %",
                           three.rows.by_energy, three.blocks.by_energy,
                           100.0 * three.blocks.by_energy / three.rows.by_energy));
  lesson.print();
}

std::string energy_text(double energy) { return fmt::format("{:>12.4g}", energy); }

void print_bob(Lesson& lesson, const BlocksRuns& all) {
  const BlocksSettings& settings = all.settings;
  const Matrix<double>& A = all.bob_A;
  lesson.print(
      fmt::format("Bob.  A = [{:.6g} {:.6g}; {:.6g} {:.6g}] 1/kg", A(0, 0), A(0, 1), A(1, 0), A(1, 1)));
  lesson.print(fmt::format("  A sweep of two rows leaves {:.7f} of the error; {} sweeps leave {:.5f}",
                           all.bob_rate, settings.sweeps, std::pow(all.bob_rate, settings.sweeps)));
  lesson.print(
      "  energy (J) after      0 s       0.5 s         1 s         2 s        10 s   furthest off (m)");
  for (const auto& [name, run] : {std::pair{"rows", &all.bob_rows}, std::pair{"block", &all.bob_block}}) {
    std::string line = fmt::format("  {:<10}", name);
    for (const double time : {0.0, 0.5, 1.0, 2.0, 10.0}) {
      const int step = static_cast<int>(std::lround(time / settings.dt));
      line += energy_text(run->energy[std::min(step, run->energy.size() - 1)]);
    }
    lesson.print(line + fmt::format("{:>14.3g}", run->largest_stretch));
  }
  lesson.print();
}

double distance(const Pair& a, const Pair& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

void check_rod(Lesson& lesson, const BlocksRuns& all) {
  const RodRun& rod = all.rod;
  // Some 16 roundings of J and A lambda at the size of b / A_ii < 10 N, amplified by the condition of A, 4:
  // its eigenvalues are 1 and 1 + 3.
  lesson.check_small("the pin's block is right after one sweep: λ − Newton's law (N)",
                     distance(rod.by_block[1], rod.formula), 16 * epsilon * 10 * 4);
  // From the second sweep on each sweep shrinks the one error that is left. Where the rows hardly couple the
  // error itself is soon round-off: 40 epsilon of 10 N, of an error that was `first` before.
  const double first = distance(rod.by_rows[1], rod.formula);
  const double second = distance(rod.by_rows[2], rod.formula);
  lesson.check_equal("row by row its error shrinks each sweep by A₁₂² / (A₁₁ A₂₂)", second / first, rod.rate,
                     2 * 16 * epsilon * 40 / first);
}

/// What the page says of A and λ of the welded beams.
void check_welds(Lesson& lesson, const ChainRun& chain) {
  const SystemMatrices<double> system = system_matrices(chain.problem);
  const Vector<double> exact = system.A.ldlt().solve(system.b);
  // 64 roundings of 45 N m, amplified by the condition of A, which is below 10⁴.
  const double moment = 3 * gravity * 1.5 * beam_length;
  lesson.check_equal("three welded beams: the largest λ is the moment at the wall (N m)",
                     exact.lpNorm<Eigen::Infinity>(), moment, 64 * epsilon * 1e4 * moment);
  const double inertia = (beam_length * beam_length + beam_height * beam_height) / 12;
  const double first = -beam_length / 2 / inertia;
  lesson.check_equal("A_yθ of the first weld is −(1/2 m)/I (1/(kg m))", system.A(1, 2), first,
                     16 * epsilon * std::abs(first));
  lesson.check_small("A_yθ of the second and of the third is 0 (1/(kg m))",
                     std::max(std::abs(system.A(4, 5)), std::abs(system.A(7, 8))),
                     16 * epsilon * std::abs(first));
}

void check_chains(Lesson& lesson, const BlocksRuns& all) {
  const ChainRun& three = all.chains[welded_three];
  check_welds(lesson, three);
  // Counts of some 400 and 300 sweeps: one sweep more or less is a third of a percent.
  lesson.check_equal("three beams: left by √(eᵀ A e) as by the largest error (%)",
                     100.0 * three.blocks.by_energy / three.rows.by_energy, share_left(three), 1);
  lesson.check_equal("one weld as a block: sweeps to 1 %", all.chains[welded_one].blocks.sweeps, 1, 0);
  int difference = 0;
  int worst = 0;
  for (const ChainRun& chain : all.chains) {
    worst = std::max(worst, chain.blocks.sweeps - chain.rows.sweeps);
    if (chain.dense_sweeps < 0) continue;
    difference = std::max({difference, std::abs(chain.dense_sweeps - chain.rows.sweeps),
                           std::abs(chain.dense_block_sweeps - chain.blocks.sweeps)});
  }
  // Counts may differ by 1 only where an error is 1 % but for rounding.
  lesson.check_small("sweeps differ from those of Gauss-Seidel with a dense A by", difference, 1);
  lesson.check_small("sweeps to 1 % that blocks need more than rows, in any of these chains", worst, 0);
  const ChainRun& ten = all.chains[welded_ten];
  const double work = static_cast<double>(ten.blocks.work) / static_cast<double>(ten.rows.work);
  lesson.check_that("ten welds: blocks take more multiply-adds to 1 % than rows", work > 1,
                    fmt::format("{:.2f} times", work));
}

void check_bob(Lesson& lesson, const BlocksRuns& all) {
  // stretch_bound() and energy_bound() say where the bounds come from.
  lesson.check_small("block: the bob leaves its circle by no more than (ω Δt)² / 2β (m)",
                     all.bob_block.largest_stretch, stretch_bound(all.settings));
  const double bound = energy_bound(all.settings);
  lesson.check_that("block: its energy never exceeds start, sway and stretch (J)",
                    all.bob_block.largest_energy <= bound,
                    fmt::format("{:.4f} <= {:.4f}", all.bob_block.largest_energy, bound));
  // Of rows this lesson claims nothing where their sweeps take a noticeable part of the error away.
  if (!(std::pow(all.bob_rate, all.settings.sweeps) > 0.99)) return;
  lesson.check_that("rows: energy for a height of 100 m, out of nothing (J)",
                    all.bob_rows.largest_energy > 1000, fmt::format("{:.3g}", all.bob_rows.largest_energy));
}

}  // namespace

void print_scene(Lesson& lesson, const BlocksSettings& settings) {
  lesson.print(fmt::format(
      "Scene: g = {:g} m/s², Δt = {:g} s; every body has 1 kg.  A rod of {:g} m on a pin, at {:g}°.", gravity,
      settings.dt, rod_length, settings.angle));
  lesson.print(
      fmt::format("  Beams of {:g} × {:g} m.  A bob with I = {:g} kg m² on a pin, arm 1 m, {} sweeps a step.",
                  beam_length, beam_height, settings.inertia, settings.sweeps));
}

void print_runs(Lesson& lesson, const BlocksRuns& all) {
  lesson.print();
  print_rod(lesson, all);
  print_chains(lesson, all);
  print_bob(lesson, all);
}

void check_runs(Lesson& lesson, const BlocksRuns& all) {
  check_rod(lesson, all);
  check_chains(lesson, all);
  check_bob(lesson, all);
}

CsvTable sweeps_table(const BlocksRuns& all) {
  CsvTable table{.header = {"scene", "solver", "sweep", "error"}};
  for (const ChainRun& chain : all.chains) {
    for (int k = 0; k < chain.rows.error.size(); ++k)
      table.rows.push_back({chain.name, "SI", k, chain.rows.error[k]});
    for (int k = 0; k < chain.blocks.error.size(); ++k)
      table.rows.push_back({chain.name, "block SI", k, chain.blocks.error[k]});
  }
  return table;
}

BlocksSettings settings_of(const Lesson& lesson) {
  return {.dt = lesson.real("dt"),
          .angle = lesson.real("angle"),
          .inertia = lesson.real("inertia"),
          .sweeps = lesson.whole("sweeps")};
}

}  // namespace cairn::blocks
