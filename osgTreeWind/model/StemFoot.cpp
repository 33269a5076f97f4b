// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/StemFoot.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>

namespace osgTreeWind {
namespace {

constexpr float highestFlare = 1.2f; // metres

} // namespace

StemFoot::StemFoot(const Skeleton& skeleton)
    : _flare(skeleton.flare),
      _height(_flare > 0.0f ? glm::min(0.1f * skeleton.height(), highestFlare) : 0.0f) {}

float StemFoot::widening(float z, float angle) const {
    if (z >= _height)
        return 1.0f;
    const float wider = 0.01f * (power(100.0f, 1.0f - glm::max(z, 0.0f) / _height) - 1.0f);
    const float roots = 0.28f * sine(5.0f * angle) + 0.2f * sine(3.0f * angle + 1.7f);
    return 1.0f + _flare * wider * (1.0f + roots);
}

} // namespace osgTreeWind
