// Which verbs there are.
#include "lessons/sandbox/verbs.hpp"

#include <cairn/math/list.hpp>

namespace cairn::sandbox {

const List<Verb>& verbs() {
  static const List<Verb> all = {list_verb(),     run_verb(),      explain_verb(),   compare_verb(),
                                 inspect_verb(),  freeze_verb(),   tradeoff_verb(),  tune_verb(),
                                 validate_verb(), extremes_verb(), recommend_verb(), completion_verb()};
  return all;
}

}  // namespace cairn::sandbox
