// Begins the program of an exercise in place of a main(), which its reader may have written: the linker
// leaves that one alone. CAIRN_EXERCISE is the namespace of the exercise, CAIRN_EXERCISE_FILE its
// exercise.cpp.
#include "lessons/kit/exercise.hpp"

namespace cairn::CAIRN_EXERCISE {
Exercise exercise();
}

extern "C" int __wrap_main(int count, char** words) {
  return cairn::exercise_program(cairn::CAIRN_EXERCISE::exercise(), CAIRN_EXERCISE_FILE, count, words);
}
