// Within a step: row updates and sweeps of its first solve.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <cairn/math/check.hpp>
#include "lessons/playground/playground.hpp"
#include "render/page.hpp"

namespace cairn::playground {

void Playground::advance_rows(int count) {
  require(count >= 1 && count <= most_steps, "row", "count", fmt::format("from 1 to {}", most_steps), count);
  const int all = look(0).all_updates;
  if (all == 0 && look(0).given.row_count() > 0) {
    throw std::invalid_argument(controls_.setting.solver +
                                " has no updates of single rows: take a whole step");
  }
  const int next = cursor_.value_or(0) + count;
  if (next > all || !go_to_row(next)) step(1);
}

void Playground::visit_row(int updates) {
  const int all = look(0).all_updates;
  require(updates >= 0 && updates <= all, "visit", "updates", fmt::format("from 0 to {}", all), updates);
  if (updates > 0) return void(go_to_row(updates));
  cursor_.reset();
  lit_row_ = -1;
  forget_look();
  words_ = "Before the step.";
}

/// Whether there is such an update: a time budget may end the solve sooner.
bool Playground::go_to_row(int next) {
  forces();  // of the whole solve
  List<SolveLook> looks = looks_of(benches_, next);
  if (!looks[0].last) return false;
  cursor_ = next;
  looks_ = std::move(looks);
  const RowUpdate<double>& update = *look(0).last;
  lit_row_ = update.row;
  const double dt = look(0).given.dt;
  words_ = fmt::format("Sweep {}, row {}: from {} to {} newtons.", update.sweep, update.row + 1,
                       render::readable(update.impulse_before / dt, 2),
                       render::readable(update.impulse_after / dt, 2));
  return true;
}

void Playground::advance_sweep() {
  const SolveLook& now = look(0);
  const int sweeps = now.residuals.size() - 1;
  const int a_sweep = std::max(1, now.all_updates / std::max(1, sweeps));
  advance_rows(a_sweep - cursor_.value_or(0) % a_sweep);
  const SolveLook& then = look(0);
  if (!then.last) return;
  lit_row_ = -1;
  words_ = fmt::format("After sweep {}: the residual is {:.2g}.", then.last->sweep,
                       then.residuals[then.last->sweep]);
}

}  // namespace cairn::playground
