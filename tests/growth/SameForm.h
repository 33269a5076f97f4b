// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>

#include <algorithm>
#include <cstring>

namespace osgTreeWind {

inline bool sameBits(float a, float b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool sameBits(const GrownMetamer& a, const GrownMetamer& b) {
    return sameBits(a.position.x, b.position.x) && sameBits(a.position.y, b.position.y) &&
           sameBits(a.position.z, b.position.z) && a.parent == b.parent && a.axis == b.axis &&
           a.order == b.order && a.born == b.born && a.dead == b.dead && sameBits(a.radius, b.radius) &&
           sameBits(a.light, b.light) && sameBits(a.leafArea, b.leafArea);
}

inline bool sameBits(const GrownForm& a, const GrownForm& b) {
    return a.years == b.years && sameBits(a.spread, b.spread) && sameBits(a.heightFactor, b.heightFactor) &&
           sameBits(a.widthFactor, b.widthFactor) &&
           std::equal(a.metamers.begin(), a.metamers.end(), b.metamers.begin(), b.metamers.end(),
                      [](const GrownMetamer& p, const GrownMetamer& q) { return sameBits(p, q); });
}

} // namespace osgTreeWind
