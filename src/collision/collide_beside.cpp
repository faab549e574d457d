// Floor 2. The narrowphase where one of two hulls has neighbours.
//
// As for any two hulls, but what the neighbours forbid is no answer: neither a face that they cover, nor a
// face of the moving hull whose normal may not stand on the corner that is nearest to it. What is then
// nearest may lie beyond the end of the best face. There, over a valley, the face goes on as a plane: a body
// that is about to leave one side of a valley has met the other side's plane in time. Over a ridge, or on the
// level, the neighbour is nearer, and has the contact. So it has where the plane of its face, through a
// ridge, is farther from what moves than every face that counts.
#include <cairn/collision/collide_beside.hpp>

namespace cairn::narrowphase {
namespace {

// Of the size of what moves. A thin board that rests on a face within the slop has its middle behind that
// face; only what has it farther behind is taken to come from there.
constexpr double behind_share = 0.05;

// Less than the least angle of a ridge, and more than a float rounds off.
constexpr float same_normal = 5e-7f;
// Of what neighbours may be apart by: planes at distances that differ by less are at one.
constexpr float same_plane = 1e-3f;

template <Scalar Real>
Vec2<Real> middle_of(const RoundedHull<Real>& hull) {
  Vec2<Real> sum = Vec2<Real>::Zero();
  for (int i = 0; i < hull.count; ++i) sum += hull.vertex(i);
  return sum / static_cast<Real>(hull.count);
}

/// The hull that stays, in its neighbours, and the one that moves.
template <Scalar Real>
class Beside {
 public:
  Beside(const Pair<Real>& pair, Side still, const Neighbours<Real>& around, const Rotation<Real>& rotation)
      : pair_(pair),
        side_(still),
        still_(still == Side::a ? pair.a : pair.b),
        mover_(still == Side::a ? pair.b : pair.a),
        around_(around),
        rotation_(rotation),
        middle_(middle_of(mover_)),
        holds_middle_(height_over_all() <= around.slack) {}

  Manifold<Real> manifold() const {
    if (still_.face_count() != around_.faces.size()) return {};  // a link that is a point in this scalar
    if (around_.one_sided && height_of_middle(0) < -behind()) return {};
    const FaceQuery<Real> on_still =
        farthest_face(still_, mover_, [this](int face, int) { return is_exposed(face); });
    const FaceQuery<Real> on_mover =
        farthest_face(mover_, still_, [this](int face, int vertex) { return may_rest_on(vertex, face); });
    const Real separation = std::max(on_still.separation, on_mover.separation);
    if (!std::isfinite(separation)) {
      return holds_middle_ && !around_.one_sided ? collide_hulls(pair_) : Manifold<Real>{};
    }
    if (separation - pair_.radii() >= pair_.margin) return {};
    if (farthest_neighbour() > separation + pair_.rounding + same_plane * around_.slack) return {};
    if (separation >= -pair_.rounding) {  // The cores are apart.
      const EdgeDistances<Real> nearest = nearest_edges_of(on_still, on_mover);
      if (corners_are_nearer(nearest, pair_.rounding)) return between_corners(nearest, on_still);
    }
    const Real bias = static_cast<Real>(reference_bias) * std::min(still_.size(), mover_.size());
    if (on_still.separation >= on_mover.separation - bias) return on_face(on_still);
    return better_face_contact(pair_, side_ == Side::a ? FaceQuery<Real>{} : on_mover,
                               side_ == Side::a ? on_mover : FaceQuery<Real>{});
  }

 private:
  // [m] Over a face of the hull that stays.
  Real height_of_middle(int face) const { return still_.normal(face).dot(middle_ - still_.vertex(face)); }
  Real height_over_all() const {
    Real height = -std::numeric_limits<Real>::infinity();
    for (int face = 0; face < still_.face_count(); ++face) height = std::max(height, height_of_middle(face));
    return height;
  }
  Real behind() const { return static_cast<Real>(behind_share) * (mover_.size() + 2 * mover_.radius); }

  /// Whether a normal at a point of the surface leads towards the middle of what moves. What has its middle
  /// in the hull, wherever the surface is, may go any way. What has it beyond a face that is covered belongs
  /// to the neighbour, and is not to be driven out through the hull.
  bool leads_out(const Vec2<Real>& normal, const Vec2<Real>& point) const {
    return holds_middle_ || around_.one_sided || normal.dot(middle_ - point) > -behind();
  }

  Vec2<Real> way_along(int face) const { return perpendicular(still_.normal(face)); }
  Real length_of(int face) const {
    return way_along(face).dot(still_.vertex(still_.next(face)) - still_.vertex(face));
  }

  bool is_partly_covered(int face) const {
    const auto& known = around_.faces[face];
    return known.first > around_.slack || known.last < length_of(face) - around_.slack;
  }

  /// Whether the moving hull reaches what is not covered of a face, from outside.
  bool is_exposed(int face) const {
    const auto& known = around_.faces[face];
    if (known.is_covered() || !leads_out(still_.normal(face), still_.vertex(face))) return false;
    if (!is_partly_covered(face)) return true;
    const Vec2<Real> way = way_along(face);
    Real least = std::numeric_limits<Real>::infinity(), most = -least;
    for (int i = 0; i < mover_.count; ++i) {
      const Real along = way.dot(mover_.vertex(i) - still_.vertex(face));
      least = std::min(least, along);
      most = std::max(most, along);
    }
    return most + mover_.radius > known.first && least - mover_.radius < known.last;
  }

  /// Whether a normal may stand on a vertex, if need be `inside` its cone: the sine of its angle to both
  /// ends.
  bool may_stand_on(int vertex, const Vec2<Real>& normal, Real inside) const {
    const auto& corner = around_.corners[vertex];
    for (int i = 0; i < corner.count; ++i) {
      const Vec2<Real> from = rotation_ * corner.cones[i].from, to = rotation_ * corner.cones[i].to;
      const bool is_between = cross(from, normal) >= inside && cross(normal, to) >= inside;
      if (is_between && normal.dot(from + to) >= 0) return true;
    }
    return corner.is_alone;
  }

  /// Whether a face of the moving hull may rest on a vertex. Where its normal is that of a face of the hull
  /// that stays, up to rounding, it is that face which gives the contact. A vertex at the far end of what is
  /// covered of a face counts only where it lies on the moving face itself.
  bool may_rest_on(int vertex, int face) const {
    const Real rounding = std::max(Real(1e-6), 16 * std::numeric_limits<Real>::epsilon());
    const Vec2<Real> normal = -mover_.normal(face);
    if (!leads_out(normal, still_.vertex(vertex)) || !may_stand_on(vertex, normal, rounding)) return false;
    if (!is_partly_covered(vertex) && !is_partly_covered(still_.previous(vertex))) return true;
    const Vec2<Real> arm = mover_.vertex(mover_.next(face)) - mover_.vertex(face);
    const Real along = arm.dot(still_.vertex(vertex) - mover_.vertex(face));
    return along > 0 && along < arm.squaredNorm();
  }

  /// [m] How far the moving hull is from the planes of the faces that neighbours have beyond a ridge. Over
  /// one that is level with its own face it is as far as over that, up to a rounding of any size: it says
  /// nothing.
  Real farthest_neighbour() const {
    Real farthest = -std::numeric_limits<Real>::infinity();
    for (int vertex = 0; vertex < still_.count; ++vertex) {
      const auto& corner = around_.corners[vertex];
      for (int i = 0; i < corner.count; ++i) {
        for (const Vec2<Real>& side : {corner.cones[i].from, corner.cones[i].to}) {
          const Vec2<Real> normal = rotation_ * side;
          if (is_own(normal, vertex) || is_own(normal, still_.previous(vertex))) continue;
          farthest = std::max(farthest, least_height(normal, still_.vertex(vertex)));
        }
      }
    }
    return farthest;
  }
  bool is_own(const Vec2<Real>& normal, int face) const {
    return (normal - still_.normal(face)).cwiseAbs().maxCoeff() < same_normal;
  }

  /// [m] Of the moving hull over a plane.
  Real least_height(const Vec2<Real>& normal, const Vec2<Real>& on_plane) const {
    Real least = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < mover_.count; ++i) {
      least = std::min(least, normal.dot(mover_.vertex(i) - on_plane));
    }
    return least;
  }

  EdgeDistances<Real> nearest_edges_of(const FaceQuery<Real>& on_still,
                                       const FaceQuery<Real>& on_mover) const {
    return side_ == Side::a ? nearest_edges(pair_, on_still, on_mover)
                            : nearest_edges(pair_, on_mover, on_still);
  }

  Manifold<Real> between_corners(const EdgeDistances<Real>& nearest, const FaceQuery<Real>& on_still) const {
    const int vertex = side_ == Side::a ? nearest.corner_a : nearest.corner_b;
    const Manifold<Real> manifold = corner_contact(pair_, nearest.corner_a, nearest.corner_b);
    const Vec2<Real> normal = side_ == Side::a ? manifold.normal : -manifold.normal;
    if (manifold.count == 0 || may_stand_on(vertex, normal, 0)) return manifold;
    return std::isfinite(on_still.separation) ? on_face(on_still) : Manifold<Real>{};
  }

  /// On a face of the hull that stays, unless what touches it there touches a neighbour instead.
  Manifold<Real> on_face(const FaceQuery<Real>& query) const {
    const Clip<Real> ends = clip(still_, query, mover_, pair_.rounding);
    if (ends.count == 1 && is_answered(query, ends.points[0])) return {};
    const bool on_a = side_ == Side::a;
    Manifold<Real> manifold =
        face_contact(still_, query, mover_, pair_, on_a ? FeatureKind::face_of_a : FeatureKind::face_of_b);
    if (!on_a) manifold.normal = -manifold.normal;
    return manifold;
  }

  /// Whether a vertex of the moving hull lies beyond the end of a face, where something else is nearer.
  bool is_answered(const FaceQuery<Real>& query, const IncidentPoint<Real>& point) const {
    using Kind = typename FaceEnd<Real>::Kind;
    const auto& known = around_.faces[query.face];
    const bool is_before = point.along < -around_.slack;
    if (!is_before && point.along <= length_of(query.face) + around_.slack) return false;
    const FaceEnd<Real>& end = is_before ? known.start : known.end;
    if (end.kind != Kind::valley) return end.kind == Kind::neighbour;
    // What is below the plane before it has reached it has sunk into the other side of the valley. And in a
    // valley so wide that nothing gets deep in it, a body need not be turned before it is there.
    if (query.separation < pair_.radii() || end.rise * pair_.margin < behind()) return true;
    const Vec2<Real>& corner = still_.vertex(is_before ? query.face : still_.next(query.face));
    return (mover_.vertex(point.vertex) - corner).norm() > pair_.radii() + pair_.margin;
  }

  const Pair<Real>& pair_;
  Side side_;
  const RoundedHull<Real>& still_;
  const RoundedHull<Real>& mover_;
  const Neighbours<Real>& around_;
  const Rotation<Real>& rotation_;
  Vec2<Real> middle_;  // of the moving hull
  bool holds_middle_;  // the hull that stays has it inside
};

}  // namespace

template <Scalar Real>
Manifold<Real> collide_beside(const Pair<Real>& pair, Side still, const Neighbours<Real>& around,
                              const Rotation<Real>& rotation) {
  return Beside<Real>(pair, still, around, rotation).manifold();
}

template Manifold<float> collide_beside(const Pair<float>&, Side, const Neighbours<float>&,
                                        const Rotation<float>&);
template Manifold<double> collide_beside(const Pair<double>&, Side, const Neighbours<double>&,
                                         const Rotation<double>&);

}  // namespace cairn::narrowphase
