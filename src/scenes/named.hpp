// Floor 8. What scene files, flags and the playground call the values of enumerations.
#pragma once

#include <stdexcept>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/friction_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/math/list.hpp>
#include <cairn/solvers/row_order.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// What a world computes in.
enum class Precision { single_precision, double_precision };

/// A value of an enumeration, and its word.
template <typename Enum>
struct Named {
  Enum value = {};
  std::string word = "";     // "split-impulse"
  std::string meaning = "";  // where lists explain it
};

template <typename Enum>
using NamedList = List<Named<Enum>>;

// All values of an enumeration, whichever is passed, in the order in which lists show them.
inline NamedList<StabilizationPolicy> named_values(StabilizationPolicy) {
  using enum StabilizationPolicy;
  return {
      {none, "none", "errors in positions stay, and grow by the error of integration"},
      {baumgarte, "baumgarte", "velocities carry a share of the error for every step, and keep that speed"},
      {relaxed, "relaxed",
       "as baumgarte; a second solve takes the speed out again, and joints follow their arcs"},
      {soft, "soft", "stiff springs in the rows; a second solve takes their speed out again"},
      {split_impulse, "split-impulse", "velocities of their own move the bodies once, and are forgotten"}};
}
inline NamedList<ContactSearch> named_values(ContactSearch) {
  using enum ContactSearch;
  return {{every_substep, "every-substep"}, {every_step, "every-step"}, {when_moved, "when-moved"}};
}
inline NamedList<Precision> named_values(Precision) {
  return {{Precision::single_precision, "float"}, {Precision::double_precision, "double"}};
}
inline NamedList<RowOrder> named_values(RowOrder) {
  using enum RowOrder;
  return {{as_written, "as-written"},
          {reverse, "reverse"},
          {alternating, "alternating"},
          {shuffled, "shuffled"},
          {coloured, "coloured"}};
}
inline NamedList<BodyType> named_values(BodyType) {
  using enum BodyType;
  return {{dynamic, "dynamic"}, {static_body, "static"}, {kinematic, "kinematic"}};
}
inline NamedList<FrictionRows> named_values(FrictionRows) {
  return {{FrictionRows::per_point, "per-point"}, {FrictionRows::per_manifold, "per-manifold"}};
}
inline NamedList<Impacts> named_values(Impacts) {
  return {{Impacts::at_once, "at-once"}, {Impacts::sequence, "sequence"}};
}
inline NamedList<MixingRule> named_values(MixingRule) {
  using enum MixingRule;
  return {{geometric_mean, "geometric-mean"},
          {minimum, "minimum"},
          {average, "average"},
          {maximum, "maximum"},
          {product, "product"}};
}
inline NamedList<JointCollision> named_values(JointCollision) {
  using enum JointCollision;
  return {{as_usual, "as-usual"}, {on, "on"}, {off, "off"}};
}
inline NamedList<DistanceJoint::Kind> named_values(DistanceJoint::Kind) {
  using enum DistanceJoint::Kind;
  return {{rod, "rod"}, {rope, "rope"}, {spring, "spring"}};
}
inline NamedList<PulleyJoint::Kind> named_values(PulleyJoint::Kind) {
  return {{PulleyJoint::Kind::rope, "rope"}, {PulleyJoint::Kind::taut, "taut"}};
}
inline NamedList<PulleyJoint::Roller> named_values(PulleyJoint::Roller) {
  return {{PulleyJoint::Roller::smooth, "smooth"}, {PulleyJoint::Roller::drum, "drum"}};
}
inline NamedList<GearJoint::Mesh> named_values(GearJoint::Mesh) {
  return {{GearJoint::Mesh::external, "external"},
          {GearJoint::Mesh::internal, "internal"},
          {GearJoint::Mesh::rack, "rack"}};
}
inline NamedList<PathKind> named_values(PathKind) {
  using enum PathKind;
  return {{once, "once"}, {to_and_fro, "to-and-fro"}, {round, "round"}};
}
inline NamedList<FrictionShape> named_values(FrictionShape) {
  using enum FrictionShape;
  return {{circle, "circle"}, {square, "square"}, {aligned_square, "aligned-square"}};
}

/// All words, in the same order.
template <typename Enum>
List<std::string> words_of() {
  List<std::string> words;
  for (const Named<Enum>& each : named_values(Enum())) words.push_back(each.word);
  return words;
}

/// The word of a value.
template <typename Enum>
std::string word_of(Enum value) {
  for (const Named<Enum>& each : named_values(value)) {
    if (each.value == value) return each.word;
  }
  throw std::logic_error("word_of: a value without a word");
}

/// The value of a word. @throws std::logic_error for one that is none of words_of().
template <typename Enum>
Enum value_of(const std::string& word) {
  for (const Named<Enum>& each : named_values(Enum())) {
    if (each.word == word) return each.value;
  }
  throw std::logic_error("value_of: there is no word " + word);
}

}  // namespace cairn
