// Which verbs there are.
#include "lessons/sandbox/verbs.hpp"

namespace cairn::sandbox {

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all = {
      list_verb(),     run_verb(),  explain_verb(),  compare_verb(),  inspect_verb(),   freeze_verb(),
      tradeoff_verb(), tune_verb(), validate_verb(), extremes_verb(), recommend_verb(), completion_verb()};
  return all;
}

}  // namespace cairn::sandbox
