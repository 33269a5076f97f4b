// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Functions of <cmath> with the same bits on every system. C libraries differ in the last bit, with which a
/// seed would grow another tree and a forest would move in another way. These use only + - * / and the square
/// root, which IEEE 754 rounds in one way, and those functions of <cmath> that are exact. Angles are in
/// radians.
///
/// Errors are below 0.52 ulp, but 1 ulp of sin, cos, tan and of results below the smallest normal number, and
/// 2 ulp of erf. Special values give what Annex F of C says. Beyond 2^30, sin, cos and tan have the period
/// of the double that is nearest to 2 pi.
namespace math {

double sin(double angle);
double cos(double angle);
double tan(double angle);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double pow(double base, double exponent);
double cbrt(double x);
double hypot(double x, double y);
double erf(double x);

// Those of floats compute in double and round once.
float sin(float angle);
float cos(float angle);
float exp(float x);
float log(float x);
inline float tan(float angle) {
    return static_cast<float>(tan(static_cast<double>(angle)));
}
inline float asin(float x) {
    return static_cast<float>(asin(static_cast<double>(x)));
}
inline float acos(float x) {
    return static_cast<float>(acos(static_cast<double>(x)));
}
inline float atan(float x) {
    return static_cast<float>(atan(static_cast<double>(x)));
}
inline float atan2(float y, float x) {
    return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}
inline float log2(float x) {
    return static_cast<float>(log2(static_cast<double>(x)));
}
inline float pow(float base, float exponent) {
    return static_cast<float>(pow(static_cast<double>(base), static_cast<double>(exponent)));
}
inline float cbrt(float x) {
    return static_cast<float>(cbrt(static_cast<double>(x)));
}
inline float hypot(float x, float y) {
    return static_cast<float>(hypot(static_cast<double>(x), static_cast<double>(y)));
}

} // namespace math

} // namespace osgTreeWind
