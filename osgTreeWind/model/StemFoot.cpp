// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/StemFoot.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgTreeWind {
namespace {

constexpr float highestFlare = 1.2f; // metres

/// A root's direction around the stem, radians, and its part of the flare.
struct Root {
    float angle, share;
};
constexpr Root roots[] = {{0.35f, 0.22f}, {1.45f, 0.16f}, {2.65f, 0.26f}, {3.85f, 0.17f}, {5.15f, 0.19f}};
constexpr float sharpness = 20.0f,
                meanRidge = 0.1254f; ///< Power of a root's outline, and the outline's mean.
constexpr float betweenRoots = 0.1f; ///< Part of the flare that is not in roots.

} // namespace

StemFoot::StemFoot(const Skeleton& skeleton)
    : _flare(skeleton.flare),
      _height(_flare > 0.0f ? glm::min(0.1f * skeleton.height(), highestFlare) : 0.0f) {}

float StemFoot::widening(float z, float angle) const {
    if (z >= _height)
        return 1.0f;
    const float wider = 0.01f * (math::pow(100.0f, 1.0f - glm::max(z, 0.0f) / _height) - 1.0f);
    float ridges = betweenRoots;
    for (const Root& root : roots)
        ridges += (1.0f - betweenRoots) / meanRidge * root.share *
                  math::pow(0.5f + 0.5f * math::cos(angle - root.angle), sharpness);
    return 1.0f + _flare * wider * ridges;
}

glm::vec3 StemFoot::normal(float z, float angle, float radius) const {
    constexpr float step = 0.05f; // radians; over the height of the foot
    const float around = widening(z, angle + step) - widening(z, angle - step),
                upward = widening(z + step * _height, angle) - widening(z - step * _height, angle);
    return glm::normalize(glm::vec3(1.0f, -around / (2.0f * step * widening(z, angle)),
                                    -radius * upward / (2.0f * step * _height)));
}

} // namespace osgTreeWind
