// What is fed with bytes: whatever they are, they are taken, or refused in one line.
#pragma once

#include <stdexcept>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::fuzz {

/// What reads the bytes.
enum class Target {
  scene,   // a scene file; the scene that it makes is stepped in double and in float
  frozen,  // a frozen problem; it is solved
  words,   // a command line of `cairn`, without its name; run where that is quick
  world,   // choices: a scene, and what happens to its world between steps (random_world.hpp)
};

/// "scene", "frozen", "words" and "world".
const List<std::string>& target_names();
/// @throws std::invalid_argument for a name that is not among them.
Target target_of(const std::string& name);

/// How an input ended that did no harm.
struct Outcome {
  bool accepted = false;
  std::string message = {};  // of a refusal
};

/// What must not happen: another exception than those for bad input, a refusal that says too little, numbers
/// that are not finite and that nobody reports, other bits where they must be the same.
struct Finding : std::logic_error {
  using std::logic_error::logic_error;
};

/// Feeds the target. The words of a command line are divided by blanks and line ends; what they write goes to
/// stdout and into the current folder.
/// @throws Finding.
Outcome feed(Target target, const std::string& bytes);

/// Command lines with every verb and every flag, to begin from.
List<std::string> word_seeds();

}  // namespace cairn::fuzz
