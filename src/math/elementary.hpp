// Floor 0. Sine, cosine, arcs and roots of squares that have the same bits everywhere. The C library's differ
// from one version to the next, and a run that uses them differs with it.
#pragma once

#include <cmath>
#include <concepts>

namespace cairn {

/// The cosine and the sine of one angle.
template <typename Real>
struct CosineAndSine {
  Real cosine = 1;  // of the angle
  Real sine = 0;    // of the angle
};

/// Both of an angle [rad] of any size, each within one unit in the last place. What is left of the angle
/// beyond whole quarter turns is taken in three parts of pi/2 (Cody and Waite 1980), or where that loses
/// digits, with the digits of 2/pi (Payne and Hanek 1983). NaN where the angle is not finite.
CosineAndSine<double> cosine_and_sine(double angle);
/// As for double, rounded.
CosineAndSine<float> cosine_and_sine(float angle);

/// The sine of an angle [rad], as cosine_and_sine() has it.
inline double sine(double angle) { return cosine_and_sine(angle).sine; }
/// The cosine of an angle [rad], as cosine_and_sine() has it.
inline double cosine(double angle) { return cosine_and_sine(angle).cosine; }
/// The tangent of an angle [rad], within 2.5 units in the last place.
double tangent(double angle);
/// The angle [rad] of the direction (x, y), in [-pi, pi], within three units in the last place; its sign is
/// y's, and it is 0 or pi where both are zero.
double arc_tangent(double y, double x);
/// The angle [rad] in [-pi/2, pi/2] whose sine is given, within four units in the last place; NaN beyond -1
/// and 1.
double arc_sine(double sine);
/// The angle [rad] in [0, pi] whose cosine is given, within four units in the last place; NaN beyond -1
/// and 1.
double arc_cosine(double cosine);

/// The length of (x, y), off by at most 2^-52 of it, without overflow or underflow on the way. NaN where x or
/// y is.
double hypotenuse(double x, double y);
/// As for double, rounded.
float hypotenuse(float x, float y);

}  // namespace cairn
