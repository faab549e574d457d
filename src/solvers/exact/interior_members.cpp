// Floor 4. Rows with one bound or none, and the friction that they limit.
#include <cairn/solvers/exact/interior_members.hpp>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

/// Of a row that is no friction; false: it has two bounds.
bool describe(const Bounds<double>& bounds, InteriorMember& member) {
  const bool has_lower = std::isfinite(bounds.lower), has_upper = std::isfinite(bounds.upper);
  if (has_lower) member.bound = bounds.lower;
  if (has_upper) member.bound = bounds.upper;
  if (has_upper) member.direction = -1;
  if (!has_lower && !has_upper) member.sides = 0;
  return !(has_lower && has_upper);
}

/// The member of row `normal`, if there is one: members are in the order of rows.
InteriorMember* member_of(int normal, List<InteriorMember>& members) {
  const auto is_before = [](const InteriorMember& member, int row) { return member.row < row; };
  const auto found = std::lower_bound(members.begin(), members.end(), normal, is_before);
  return found != members.end() && found->row == normal ? &*found : nullptr;
}

}  // namespace

bool find_interior_members(const ScaledRows<double>& rows, List<InteriorMember>& members) {
  members.clear();
  bool fits = true;
  for (int i = 0; i < rows.rows().size(); ++i) {
    const auto& row = rows.rows()[i];
    if (row.unit == 0 || row.bounds.is_friction()) continue;
    members.push_back({.row = i});
    fits = describe(row.bounds, members.back()) && fits;
  }
  for (int i = 0; i < rows.rows().size(); ++i) {
    const auto& row = rows.rows()[i];
    if (row.unit == 0 || !row.bounds.is_friction()) continue;
    const bool has_one_normal =
        !(row.bounds.disc > 0) && row.bounds.second_normal_row == Bounds<double>::none;
    InteriorMember* const member = has_one_normal ? member_of(row.bounds.normal_row, members) : nullptr;
    if (member == nullptr || member->friction >= 0 || member->sides != 1 || member->direction < 0 ||
        member->bound != 0)
      return false;
    member->friction = i;
    member->sides = 2;
    member->ratio = row.bounds.friction * rows.rows()[member->row].unit / row.unit;
  }
  const auto has_bound = [](const InteriorMember& member) { return member.sides > 0; };
  return fits && std::any_of(members.begin(), members.end(), has_bound);
}

}  // namespace cairn
