// SPDX-License-Identifier: MIT
// What law files that say `real` need in GLSL. In C++ a real is a float (osgTreeWind/motion/laws/Laws.h), or the floats
// of several trees at once (osgTreeWind/motion/modal/Lanes.h).
#define real float

/// A constant, the same in every lane.
real every(float x) { return x; }

/// 2^-n for a whole n in [0, 126].
real halvings(real n) { return intBitsToFloat((127 - int(n)) << 23); }
