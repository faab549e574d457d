// Floor 4. All that lanes do, in registers of one width: compiled once for each instruction set.
#pragma once

#include <cairn/solvers/wide/lane_contact_rows.hpp>
#include <cairn/solvers/wide/lane_contact_sweep.hpp>
#include <cairn/solvers/wide/lane_filling.hpp>
#include <cairn/solvers/wide/lane_sets.hpp>
#include <cairn/solvers/wide/lane_sweep.hpp>

namespace cairn {

namespace {

template <int bytes>
void pass_over(LaneProblem& problem, LanePass pass, int first, int last) {
  pass_batches<bytes>(problem, pass, first, last);
}

template <int bytes, typename Real>
LaneCode<Real> code_in_registers_of() {
  return {.pass = pass_over<bytes>,
          .fill = fill_lanes<Real>,
          .measure_contacts = measure_contacts<Real>,
          .begin_second_solve = begin_second_solve<Real>,
          .push_contacts = push_contacts<bytes, Real>,
          .sweep_contacts = sweep_contacts<bytes, Real>,
          .fill_contacts = fill_contacts<bytes, Real>,
          .empty_contacts = empty_contacts<bytes, Real>,
          .weigh_contacts = weigh_contacts<bytes, Real>};
}

}  // namespace

}  // namespace cairn
