// The tables of the benchmark program: each prints itself.
#pragma once

namespace cairn::bench {

void print_solver_table();      // speed, memory and accuracy of every solver (paper 4.1, 4.4)
void print_layout_table();      // objects against arrays (paper 4.2, 4.4)
void print_memory_table();      // what is stored, against the number of rows (paper 4.4)
void print_block_table();       // sweeps with and without blocks (paper 4.3)
void print_lines_table();       // how much code each solver is (paper 4.2)
void print_feature_table();     // what a feature costs where it is not used
void print_policy_table();      // what becomes of errors in positions
void print_search_table();      // what it costs that manifolds last
void print_growth_table();      // what it takes to know who is near whom
void print_device_table();      // Jacobi on a device beside colours on lanes (paper 4.4)
void print_default_table();     // exact solves beside sweeps in lanes, against the number of bodies
void print_constraint_table();  // what each kind of constraint writes, and what that costs

}  // namespace cairn::bench
