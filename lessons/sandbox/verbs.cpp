// Which verbs there are. Each has a file of its own, verb_NAME.cpp.
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {

Verb list_verb();
Verb run_verb();
Verb explain_verb();
Verb compare_verb();
Verb inspect_verb();
Verb freeze_verb();
Verb tradeoff_verb();
Verb tune_verb();
Verb validate_verb();
Verb extremes_verb();
Verb recommend_verb();
Verb completion_verb();

const List<Verb>& verbs() {
  static const List<Verb> all = {list_verb(),     run_verb(),      explain_verb(),   compare_verb(),
                                 inspect_verb(),  freeze_verb(),   tradeoff_verb(),  tune_verb(),
                                 validate_verb(), extremes_verb(), recommend_verb(), completion_verb()};
  return all;
}

}  // namespace cairn::sandbox
