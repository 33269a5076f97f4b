// SPDX-License-Identifier: MIT
// Definitions for law files that use `real`. In C++, a real is a float (osgTreeWind/motion/laws/Laws.h), or one float
// for each of several trees (osgTreeWind/motion/modal/Lanes.h).
#define real float

/// A constant in all lanes.
real every(float x) { return x; }

/// 2^-n for an integer n in [0, 126].
real halvings(real n) { return intBitsToFloat((127 - int(n)) << 23); }
