// Floor 5. From which side bodies come to what is one-way.
#include <algorithm>

#include <cairn/collision/approach.hpp>
#include <cairn/world/contact_finder.hpp>

namespace cairn {

/// Whether a shape is one-way for another one. Sensors see everything.
template <Scalar Real>
bool ContactFinder<Real>::is_one_way(int shape, int other) const {
  const BodySpec& spec = step_.scene.bodies()[(*cache_.colliders_)[shape].body].spec;
  const BodySpec& spec_of_other = step_.scene.bodies()[(*cache_.colliders_)[other].body].spec;
  return !spec.filter.one_way.isZero(0) && !spec.sensor && !spec_of_other.sensor;
}

/// Whether one of two shapes passes the other, which is one-way.
template <Scalar Real>
bool ContactFinder<Real>::pass(int a, int b) const {
  const auto lets_pass = [this](int shape, int other) {
    return is_one_way(shape, other) && !cache_.sides_.holds(shape, (*cache_.colliders_)[other].body);
  };
  return lets_pass(a, b) || lets_pass(b, a);
}

/// Looks at all that is near something one-way, and notes what passes it.
template <Scalar Real>
void ContactFinder<Real>::find_sides() {
  const List<NearPair>& pairs = cache_.graph_.order();
  cache_.sides_.begin();
  for (const NearPair& near : pairs) {
    const auto [a, b] = near.shapes;
    if (is_one_way(a, b)) see_side(a, b);
    if (is_one_way(b, a)) see_side(b, a);
  }
  cache_.sides_.end();
  List<std::pair<BodyId, BodyId>>& passing = record_.passing;
  passing.clear();
  for (const NearPair& near : pairs) {
    const BodyId a = (*cache_.colliders_)[near.shapes.first].body;
    const BodyId b = (*cache_.colliders_)[near.shapes.second].body;
    if (pass(near.shapes.first, near.shapes.second)) passing.push_back(std::minmax(a, b));
  }
  std::sort(passing.begin(), passing.end());
  passing.erase(std::unique(passing.begin(), passing.end()), passing.end());
}

/// What lies no deeper below the outermost plane of the shape than it may sink in is outside.
template <Scalar Real>
void ContactFinder<Real>::see_side(int one_way, int other) {
  const Collider &it = (*cache_.colliders_)[one_way], &comes = (*cache_.colliders_)[other];
  const Frame<Real>&frame = cache_.frames_[it.body], &frame_of_other = cache_.frames_[comes.body];
  const Vec2<Real> local =
      step_.scene.bodies()[it.body].spec.filter.one_way.normalized().template cast<Real>();
  const Vec2<Real> outwards = frame.rotation * local;
  const Real gap = gap_along(outwards, *it.form->shape, frame, *comes.form->shape, frame_of_other);
  const Real slop = std::min({static_cast<Real>(*step_.plan.settings.stabilization.slop),
                              step_.kinds[it.body].slop_limit, step_.kinds[comes.body].slop_limit});
  const CachedContact<Real> pair = {.collider_a = one_way, .collider_b = other};
  const bool overlaps = collide_pair(pair, frame, frame_of_other, 0).count > 0;
  cache_.sides_.see({one_way, comes.body, gap >= -slop, overlaps});
}

template class ContactFinder<float>;
template class ContactFinder<double>;

}  // namespace cairn
