// Prints the loads, the sweeps of a cold step and what a bouncing ball does, and checks them against theory.
#include "lesson.hpp"

namespace cairn::warm {

namespace {

/// See lesson 17: each visit rounds sums of at most twice the weight. Where a contact has opened, its bias
/// adds a rounding of the height, over dt^2, in every step.
double load_rounding(const StartSettings& settings) {
  const double visits = double(settings.steps) * settings.sweeps * 2 * settings.boxes;
  const double heights = settings.steps * settings.boxes / (settings.dt * settings.dt);
  return epsilon * (2 * settings.weight() * visits + 4 * heights);
}

double largest_gap(const List<List<double>>& first, const List<List<double>>& second, int frames) {
  double largest = 0;
  for (int k = 0; k <= frames; ++k) {
    for (int i = 0; i < first[k].size(); ++i) {
      largest = std::max(largest, std::abs(first[k][i] - second[k][i]));
    }
  }
  return largest;
}

void check_runs(Lesson& lesson, const WarmStart& all) {
  const StartSettings& settings = all.settings;
  lesson.check_that("step 1 is the same for both: there is nothing to remember yet",
                    all.cold.loads[1] == all.warm.loads[1], fmt::format("{:.2f} N", all.cold.loads[1][0]));
  lesson.check_that("the world's own warm start: the same loads, to the last bit",
                    all.library.loads == all.warm.loads, fmt::format("{} steps", settings.steps));
  const double rounding = load_rounding(settings);
  lesson.check_small("warm: Gauss-Seidel on masses on a line, in plain loops (N)",
                     largest_gap(all.warm.loads, loads_by_hand(settings), settings.steps), rounding);
  const ColdTheory theory = cold_by_matrix(settings);
  const int last = all.cold.comparable;
  lesson.check_small("cold: λ by powers of the matrix of Gauss-Seidel (N)",
                     largest_gap(all.cold.loads, theory.loads, last), rounding);
  // A velocity is a sum of as many impulses; rounding of a load times dt.
  lesson.check_equal(fmt::format("cold: the top sinks in step {} at the speed that follows (m/s)", last),
                     all.cold.frames[last].bodies.back().velocity.y(), theory.top_velocity[last],
                     rounding * settings.dt * settings.boxes);
}

void check_rates(Lesson& lesson, const WarmStart& all) {
  const StartSettings& settings = all.settings;
  double worst = 0;
  for (int k = 1; k <= settings.steps; ++k) {
    const double error = all.warm.loads[k][0] / settings.weight() - 1;
    // All modes together begin with the whole weight, and none shrinks more slowly than the first. A visit
    // from row to row is up to one sweep behind or ahead of the mode.
    const double bound = share_left(settings.boxes, 0.5 * settings.sweeps * k - 1) +
                         load_rounding(settings) / settings.weight();
    worst = std::max(worst, std::abs(error) / bound);
  }
  lesson.check_small("warm: |λ₁/W − 1| in units of cos(π/2n)^(sweeps × steps)", worst, 1);
  double off = 0;
  for (const ColdSweeps& cold : all.sweeps) {
    off = std::max(off, std::abs(cold.needed - needed_by_formula(cold.boxes)));
  }
  // Rounded up to a whole sweep, and up to one sweep behind or ahead, as above.
  lesson.check_small("one cold step: sweeps to 1 %, formula and count", off, 2);
}

void check_order(Lesson& lesson, const WarmStart& all) {
  const StartSettings& settings = all.settings;
  lesson.check_that("by key a ball bouncing beside it changes no bit of the tower's loads",
                    all.guest.by_key == all.warm.loads,
                    fmt::format("{} of {} steps",
                                std::count(all.guest.ball_touches.begin(), all.guest.ball_touches.end(), 1),
                                settings.steps));
  // One scaling of an impulse, one division.
  lesson.check_equal("half the Δt, half the impulse: λ₁ as before (N)", all.library.load_at_half_dt,
                     all.warm.loads.back()[0], 8 * epsilon * settings.weight() * 2);
}

}  // namespace

/// Whether the depths that the card offers are about this tower.
bool is_standard(const StartSettings& settings) { return settings.boxes == 10 && settings.dt == 0.02; }

std::string question_of(const WarmStart& all) {
  return fmt::format(
      "A tower of {} boxes does {} sweeps in each step, always from zero. In {} steps its top sinks by "
      "{:.0f}\u00a0mm. Now each step begins with the impulses of the last one, and does one sweep. How "
      "deep is the top after {} steps{}?",
      all.settings.boxes, many_sweeps, question_steps, -risen(all.many_cold, question_steps), question_steps,
      is_standard(all.settings) ? ": about 5000, 560, 180 or 20\u00a0mm" : "");
}

void tell_scene(Lesson& lesson, const StartSettings& settings) {
  lesson.print(
      fmt::format("Scene: {} boxes of 1 kg on each other, W = {:g} N, g = {:g} m/s², Δt = {:.4g} s, {} "
                  "sweeps in each step, β = 0",
                  settings.boxes, settings.weight(), gravity, settings.dt, settings.sweeps));
}

void tell_loads(Lesson& lesson, const WarmStart& all) {
  lesson.print();
  lesson.print("load on the lowest box (N), λ₁ of its contact");
  lesson.print("step          cold        warm");
  for (const int step : {1, 2, 3, 5, 10, 20, 40, 80, 120, 200, 300}) {
    if (step > all.settings.steps) break;
    lesson.print(
        fmt::format("{:>4} {:>13.2f} {:>11.2f}", step, all.cold.loads[step][0], all.warm.loads[step][0]));
  }
  const int last = all.settings.steps;
  lesson.print(
      fmt::format("top moved {:>8.1f} mm {:>8.1f} mm", risen(all.cold, last), risen(all.warm, last)));
  for (const StartRun* run : {&all.many_cold, &all.one_warm})
    lesson.print(fmt::format("{:<16} top moved {:>8.1f} mm in {} steps, {:.1f} mm at the lowest", run->name,
                             risen(*run, question_steps), question_steps, lowest(*run)));
  const double weight = all.settings.weight();
  lesson.print(fmt::format("|λ₁ − W| in the last quarter: at most {:.2g} N cold, {:.2g} N warm",
                           unrest(all.cold.loads, weight), unrest(all.warm.loads, weight)));
  lesson.print();
}

void tell_sweeps(Lesson& lesson, const WarmStart& all) {
  lesson.print("one step from zero: sweeps until the lowest contact lacks 1 %");
  for (const ColdSweeps& cold : all.sweeps) {
    lesson.print(fmt::format("  {:>2} boxes {:>6} sweeps    ln(800/π²) / (−2 ln cos(π/2n)) = {:.1f}",
                             cold.boxes, cold.needed, needed_by_formula(cold.boxes)));
  }
  lesson.print();
}

Price price_of(const WarmStart& all) {
  Price price;
  for (int k = 1; k <= question_steps; ++k) {
    const double cold = risen(all.many_cold, k), warm = risen(all.one_warm, k);
    if (warm >= cold) continue;
    ++price.deeper;
    price.last = k;
    if (warm < price.warm) price = {price.deeper, k, k, warm, cold};
  }
  return price;
}

void tell_price(Lesson& lesson, const WarmStart& all) {
  const Price price = price_of(all);
  lesson.print(fmt::format(
      "warm with 1 sweep is deeper than cold with {} in {} of the first {} steps; at its deepest, "
      "step {}: {:.0f} mm, cold {:.0f} mm",
      many_sweeps, price.deeper, price.last, price.at, -price.warm, -price.cold));
  lesson.print();
}

void tell_order(Lesson& lesson, const WarmStart& all) {
  lesson.print("A ball bounces beside the tower; when it touches the ground, its contact is the first row.");
  lesson.print(fmt::format("  |λ₁ − W| in the last quarter: at most {:.2g} N by key, {:.2g} N by number",
                           unrest(all.guest.by_key, all.settings.weight()),
                           unrest(all.guest.by_number, all.settings.weight())));
  lesson.print();
}

void check_claims(Lesson& lesson, const WarmStart& all) {
  if (is_standard(all.settings)) {
    lesson.check_that("the question has the numbers of this run", question_of(all) == card().question, "all");
    const Price price = price_of(all);
    lesson.check_that("the price: at first, warm with one sweep is deeper than cold with fifty (steps)",
                      price.deeper > price.last / 2 && price.last < question_steps / 2,
                      fmt::format("{} of {}", price.deeper, price.last));
  }
  check_runs(lesson, all);
  check_rates(lesson, all);
  check_order(lesson, all);
}

CsvTable table_of(const WarmStart& all) {
  CsvTable table{.header = {"step", "interface", "cold_newton", "warm_newton", "ball_by_number_newton"}};
  for (int k = 1; k < all.warm.loads.size(); ++k) {
    for (int i = 0; i < all.warm.loads[k].size(); ++i) {
      table.rows.push_back({k, i + 1, all.cold.loads[k][i], all.warm.loads[k][i], all.guest.by_number[k][i]});
    }
  }
  return table;
}

}  // namespace cairn::warm
