// Floor 5. The rows of a step whose solver needed none.
#include <cairn/constraints/contact_rows.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

template <Scalar Real>
StepRecord<Real> with_rows(const World<Real>& world) {
  StepRecord<Real> record = world.last_step();
  if (!record.problem.has_rows()) write_contact_rows(record.problem);
  return record;
}

template StepRecord<float> with_rows(const World<float>&);
template StepRecord<double> with_rows(const World<double>&);

}  // namespace cairn
