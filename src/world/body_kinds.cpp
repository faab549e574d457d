// Floor 5. Kinds of bodies.
#include <cairn/world/body_kinds.hpp>

namespace cairn {

template <Scalar Real>
void BodyKinds<Real>::add(const BodyForces<Real>& forces, const BodyTraits<Real>& traits) {
  const int few = 16;  // of the last kinds: they are looked through for the same
  int kind = traits_.size();
  for (int i = traits_.size() - 1; i >= 0 && i >= traits_.size() - few && kind == traits_.size(); --i) {
    if (forces_[i] == forces && traits_[i] == traits) kind = i;
  }
  if (kind == traits_.size()) {
    forces_.push_back(forces);
    traits_.push_back(traits);
  }
  kind_.push_back(kind);
}

template class BodyKinds<float>;
template class BodyKinds<double>;

}  // namespace cairn
