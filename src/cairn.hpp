// Everything a program that simulates needs to include.
#pragma once

#include <cairn/constraints/contact.hpp>
#include <cairn/constraints/contact_rows.hpp>
#include <cairn/constraints/differential_joint.hpp>
#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/drag_joint.hpp>
#include <cairn/constraints/friction_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/geometry/mass.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/measure/csv.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/measure/failure.hpp>
#include <cairn/measure/recorder.hpp>
#include <cairn/measure/tracks.hpp>
#include <cairn/measure/trajectory.hpp>
#include <cairn/measure/truth.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/solvers/exact/newton_solver.hpp>
#include <cairn/solvers/exact/reference_solver.hpp>
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/block_sequential_impulse.hpp>
#include <cairn/solvers/iterative/factored_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/jacobi.hpp>
#include <cairn/solvers/iterative/naive_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/solvers/iterative/sparse_projected_gauss_seidel.hpp>
#include <cairn/solvers/non_zeros.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/solvers/system_matrix.hpp>
#include <cairn/solvers/wide/wide_sequential_impulse.hpp>
#include <cairn/world/plan.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/world/world.hpp>

/// Bodies, what constrains them, what solves the constraints, and what measures the answers.
namespace cairn {}
