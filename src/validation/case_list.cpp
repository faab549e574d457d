// Floor 8. All closed forms, from the files that hold them.
#include <cairn/validation/case_list.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <cctype>
#include <string>
#include <tuple>
#include <utility>

namespace cairn {

namespace {

/// "B9" stands before "B10", and that before "B10b".
std::tuple<char, int, std::string> place_of(const ValidationCase& one) {
  std::size_t end = 1;
  int number = 0;
  for (; end < one.id.size() && std::isdigit(static_cast<unsigned char>(one.id[end])) != 0; ++end) {
    number = 10 * number + (one.id[end] - '0');
  }
  return {one.id.empty() ? ' ' : one.id[0], number, one.id.substr(std::min(end, one.id.size()))};
}

}  // namespace

const List<ValidationCase>& validation_cases() {
  static const List<ValidationCase> cases = [] {
    List<ValidationCase> all;
    for (const auto add : {
             add_stack_cases,    add_chain_cases,     add_beam_cases,      add_slot_cases,
             add_impact_cases,   add_hinge_cases,     add_joint_row_cases, add_paradox_cases,
             add_flight_cases,   add_momentum_cases,  add_bounce_cases,    add_slope_cases,
             add_slide_cases,    add_roll_cases,      add_ladder_cases,    add_wedge_cases,
             add_pendulum_cases, add_wheel_cases,     add_modes_cases,     add_spring_cases,
             add_pulley_cases,   add_mechanism_cases, add_rotor_cases,     add_pop_cases,
             add_capstan_cases,  add_overhang_cases,  add_arch_cases,      add_silo_cases,
             add_puck_cases,     add_rocking_cases,   add_string_cases,    add_slip_cases,
             add_drive_cases,    add_linkage_cases,   add_contact_cases,   add_field_cases,
             add_event_cases,
         }) {
      add(all);
    }
    std::stable_sort(all.begin(), all.end(), [](const ValidationCase& a, const ValidationCase& b) {
      return place_of(a) < place_of(b);
    });
    return all;
  }();
  return cases;
}

}  // namespace cairn
