// Floor 9. One step's problem, kept: every solver can be given the very same numbers.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A problem with its name. Its velocities are those before any impulse, its impulses what a solver would
/// start from.
struct FrozenProblem {
  std::string name = {};         // letters, digits, - and _: at most 64; names its file too
  std::string description = {};  // what it is of, and after which steps
  List<std::string> tags = {};   // "cold" or "warm", "40 rows", "settled" or "moving" ...
  VelocityProblem<double> problem = {};
};

/// Refuses a problem that is none; worlds write none that it refuses. Sizes agree, body 0 is the ground and
/// nothing moves it, every number is finite but for the bounds, inverse masses and softness are >= 0, every
/// index points at what exists, bounds are an interval, friction names a row that does not itself name
/// another, extra terms lie inside their array, and the blocks are consecutive and cover all rows.
/// @throws std::invalid_argument "place: rows[3].bounds.normal_row must be rule, got value".
void check(const VelocityProblem<double>& problem, const std::string& place);

/// @throws std::invalid_argument unless name, description and tags are texts of UTF-8 that have their
/// lengths, and the problem is none that is refused.
void check(const FrozenProblem& frozen, const std::string& place);

inline const std::string frozen_schema = "cairn frozen problem 1";

/// Writes JSON, one line for each body, row and block:
///   "schema"       "cairn frozen problem 1"
///   "name", "description", "tags"
///   "dt"           [s]
///   "bodies"       [inverse mass x, y, inverse inertia, v_x, v_y, w] of each; the ground first
///   "extra_terms"  [body, j_x, j_y, j_w] of each
///   "rows"         [a, b, [j of a], [j of b], bias, softness, [bounds], [key], impulse, first_extra,
///                  extra_count] of each; without extra terms the last two may be left out. Bounds are
///                  [lower, upper] or [lower, upper, friction, disc, normal_row, second_normal_row], where
///                  infinities are "inf" and "-inf" and no row is -1; a key is [source, part] in hexadecimal.
///   "blocks"       [first, count] of each
/// Numbers have 17 digits, so that they read back bit-equal.
/// @throws std::invalid_argument for a problem that read_frozen would refuse.
void write_frozen(std::ostream& out, const FrozenProblem& frozen);

/// Reads what write_frozen wrote, from the whole stream; `name` stands for it in messages.
/// @throws std::invalid_argument "name: rows[3][7] must be rule, got value" for anything else: no JSON,
/// fields that are missing, unknown or given twice, wrong types and counts, numbers out of range, a problem
/// that check() refuses, text behind the end, and more than 32 MiB.
FrozenProblem read_frozen(std::istream& in, const std::string& name);

/// The same in a file, which is written beside and then renamed: no reader ever sees half of one.
/// @throws std::runtime_error when the file cannot be read or written.
void write_frozen_file(const std::filesystem::path& path, const FrozenProblem& frozen);
FrozenProblem read_frozen_file(const std::filesystem::path& path);

}  // namespace cairn
