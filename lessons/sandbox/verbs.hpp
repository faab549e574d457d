// The verbs of `cairn`, one file for each.
#pragma once

#include "lessons/sandbox/verb.hpp"

namespace cairn::sandbox {

Verb list_verb();
Verb run_verb();
Verb explain_verb();
Verb compare_verb();
Verb inspect_verb();
Verb extremes_verb();
Verb freeze_verb();
Verb tradeoff_verb();
Verb tune_verb();
Verb recommend_verb();
Verb validate_verb();
Verb completion_verb();

}  // namespace cairn::sandbox
