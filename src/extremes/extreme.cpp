// Floor 12. From what a case does to a verdict.
#include "extremes/extreme.hpp"

#include <cmath>
#include <stdexcept>

#include "extremes/extreme_axes.hpp"
#include "math/list.hpp"

namespace cairn {

std::string verdict_text(ExtremeVerdict verdict) {
  switch (verdict) {
    case ExtremeVerdict::ok:
      return "OK";
    case ExtremeVerdict::bound:
      return "BOUND";
    case ExtremeVerdict::refuse:
      return "REFUSE";
    case ExtremeVerdict::told:
      return "TOLD";
    case ExtremeVerdict::fail:
      break;
  }
  return "FAIL";
}

bool meets(ExtremeVerdict required, ExtremeVerdict found) {
  if (required != ExtremeVerdict::bound) return found == required;
  return found == required || found == ExtremeVerdict::ok || found == ExtremeVerdict::told;
}

const List<ExtremeAxis>& extreme_axes() {
  static const List<ExtremeAxis> axes = [] {
    List<ExtremeAxis> all;
    for (const auto& group : {load_axes(), step_axes(), motion_axes(), size_axes(), row_axes(), spring_axes(),
                              material_axes(), number_axes(), count_axes(), input_axes(), target_axes()}) {
      all.insert(all.end(), group.begin(), group.end());
    }
    return all;
  }();
  return axes;
}

ExtremeFinding find_out(const ExtremeCase& extreme) {
  ExtremeFinding finding;
  try {
    finding = extreme.run(extreme.setting);
    if (!std::isfinite(finding.value)) finding.verdict = ExtremeVerdict::fail;
  } catch (const std::invalid_argument& refusal) {
    finding = {.verdict = ExtremeVerdict::refuse, .quantity = "refused", .note = refusal.what()};
    // Field, rule and value are named where the message came from `require`.
    const bool names = finding.note.find(" must be ") != std::string::npos ||
                       finding.note.find(" above the limit of ") != std::string::npos;
    if (!names) finding.verdict = ExtremeVerdict::fail;
  } catch (const std::length_error& refusal) {
    finding = {.verdict = ExtremeVerdict::refuse, .quantity = "refused", .note = refusal.what()};
  } catch (const std::exception& error) {
    finding = {.quantity = "an error", .note = error.what()};
  }
  return finding;
}

}  // namespace cairn
