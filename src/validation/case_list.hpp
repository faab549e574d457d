// Floor 8. Which file holds which closed forms: a new file is one line here and one in case_list.cpp.
#pragma once

#include <cairn/validation/case.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

using ValidationCases = List<ValidationCase>;

void add_stack_cases(ValidationCases& cases);      // A1-A3
void add_chain_cases(ValidationCases& cases);      // A4-A6, A9
void add_beam_cases(ValidationCases& cases);       // A7, A8
void add_slot_cases(ValidationCases& cases);       // A10
void add_impact_cases(ValidationCases& cases);     // A11, A12, A14
void add_hinge_cases(ValidationCases& cases);      // A15
void add_joint_row_cases(ValidationCases& cases);  // A17-A19
void add_paradox_cases(ValidationCases& cases);    // A20

void add_flight_cases(ValidationCases& cases);    // B1, B3
void add_momentum_cases(ValidationCases& cases);  // B2, B42
void add_bounce_cases(ValidationCases& cases);    // B4
void add_slope_cases(ValidationCases& cases);     // B5, B10, B11
void add_slide_cases(ValidationCases& cases);     // B6, B7
void add_roll_cases(ValidationCases& cases);      // B8, B9
void add_ladder_cases(ValidationCases& cases);    // B12
void add_wedge_cases(ValidationCases& cases);     // B14
void add_pendulum_cases(ValidationCases& cases);  // B15, B16
void add_wheel_cases(ValidationCases& cases);     // B43

void add_modes_cases(ValidationCases& cases);      // B17, B26
void add_spring_cases(ValidationCases& cases);     // B27-B29
void add_pulley_cases(ValidationCases& cases);     // B18-B20
void add_mechanism_cases(ValidationCases& cases);  // B21, B22
void add_rotor_cases(ValidationCases& cases);      // B23
void add_pop_cases(ValidationCases& cases);        // B24
void add_capstan_cases(ValidationCases& cases);    // B32
void add_slip_cases(ValidationCases& cases);       // B32b
void add_overhang_cases(ValidationCases& cases);   // B35
void add_arch_cases(ValidationCases& cases);       // B36
void add_silo_cases(ValidationCases& cases);       // B37
void add_puck_cases(ValidationCases& cases);       // B38
void add_rocking_cases(ValidationCases& cases);    // B40
void add_string_cases(ValidationCases& cases);     // B41
void add_contact_cases(ValidationCases& cases);    // B45-B49
void add_field_cases(ValidationCases& cases);      // B50-B54
void add_drive_cases(ValidationCases& cases);      // B60-B63
void add_linkage_cases(ValidationCases& cases);    // B64-B67
void add_event_cases(ValidationCases& cases);      // B70-B73

}  // namespace cairn
