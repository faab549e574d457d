// Floor 0. Scalars and small vectors: thin names over Eigen, and the planar cross products.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <numbers>

#include <cairn/math/elementary.hpp>

namespace cairn {

/// The number types Cairn computes in. Worlds are float and double; problems are long double too, where they
/// are solved exactly.
template <typename T>
concept Scalar = std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, long double>;

/// Two numbers: x and y.
template <Scalar Real>
using Vec2 = Eigen::Matrix<Real, 2, 1>;

/// Three numbers of one body: x, y and rotation (a row of eq. (1), or of the diagonal of eq. (2)).
template <Scalar Real>
using Vec3 = Eigen::Matrix<Real, 3, 1>;

/// The ratio of a circle's circumference to its diameter.
inline constexpr double pi = std::numbers::pi;

/// The sum of three products in an order that is the same everywhere: Eigen's depends on the instruction set.
/// It is the order of Eigen with SSE2, which takes doubles two at a time.
template <Scalar Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  const Real x = a.x() * b.x(), y = a.y() * b.y(), z = a.z() * b.z();
  return std::same_as<Real, double> ? (x + y) + z : x + (y + z);
}

/// The z component of a x b.
template <Scalar Real>
Real cross(const Vec2<Real>& a, const Vec2<Real>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Velocity of a point at arm r of a body that turns with angular velocity w [rad/s]: w x r.
template <Scalar Real>
Vec2<Real> cross(Real w, const Vec2<Real>& r) {
  return {-w * r.y(), w * r.x()};
}

/// v turned by +90 degrees.
template <Scalar Real>
Vec2<Real> perpendicular(const Vec2<Real>& v) {
  return {-v.y(), v.x()};
}

/// Cosine and sine of an angle, kept together so that they are computed once.
template <Scalar Real>
struct Rotation {
  Real c = 1;  // the cosine
  Real s = 0;  // the sine

  Rotation() = default;
  /// By an angle [rad], counter-clockwise.
  explicit Rotation(Real angle) : Rotation(cosine_and_sine(angle)) {}
  /// By the angle that has this cosine and this sine.
  explicit Rotation(const CosineAndSine<Real>& of) : c(of.cosine), s(of.sine) {}

  /// The rotation applied to v.
  Vec2<Real> operator*(const Vec2<Real>& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  /// The inverse rotation applied to v.
  Vec2<Real> transposed_times(const Vec2<Real>& v) const {
    return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
  }
};

/// Where a body is: its centre of mass [m] and its angle [rad], which is continuous (never wrapped).
template <Scalar Real>
struct Pose {
  Vec2<Real> position = Vec2<Real>::Zero();  // [m] of the centre of mass
  Real angle = 0;                            // [rad] counter-clockwise

  /// A point given in the body's frame, in the world.
  Vec2<Real> world(const Vec2<Real>& local) const { return position + Rotation<Real>(angle) * local; }
  /// A point given in the world, in the body's frame.
  Vec2<Real> local(const Vec2<Real>& point) const {
    return Rotation<Real>(angle).transposed_times(point - position);
  }
};

/// A pose with the cosine and the sine of its angle, for those who use them more than once.
template <Scalar Real>
struct Frame {
  Vec2<Real> position = Vec2<Real>::Zero();  // [m] of the centre of mass
  Rotation<Real> rotation = {};              // from the body's directions to the world's

  Frame() = default;
  /// Of a body at this pose.
  Frame(const Pose<Real>& pose) : position(pose.position), rotation(pose.angle) {}
};

}  // namespace cairn
