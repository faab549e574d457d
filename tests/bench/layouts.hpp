// One sweep of sequential impulses, written with arrays and with objects (paper 4.2 and 4.4).
#pragma once

#include <memory>
#include <string>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn::bench {

/// The rows of a problem, stored in one of the ways compared. All ways visit them in the same order and do
/// the same arithmetic; only where a row's numbers lie and how its code is reached differ.
class Layout {
 public:
  virtual ~Layout() = default;
  virtual std::string name() const = 0;
  /// One sweep over all rows: one virtual call, which costs nothing beside it.
  virtual void sweep(PerBody<Vec3<double>>& velocity) = 0;
  /// [N s], in the order of the problem's rows.
  virtual PerRow<double> impulses() const = 0;
};

/// All ways, from a cold start; the first is the one that the others are compared with. They keep a
/// reference to the problem's masses.
List<std::unique_ptr<Layout>> make_layouts(const VelocityProblem<double>& problem);

/// The problem with its rows in the order of RowOrder::coloured. Its blocks do not follow.
VelocityProblem<double> in_coloured_order(const VelocityProblem<double>& problem);
/// The first way, for a problem whose rows were put into coloured order.
std::unique_ptr<Layout> make_coloured_layout(const VelocityProblem<double>& coloured);

}  // namespace cairn::bench
