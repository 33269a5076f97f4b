// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/WoodVolume.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

struct ShootMeasure {
    double volume = 0.0, outline = 0.0, length = 0.0, upright = 0.0; // upright: squared sine times length
};

ShootMeasure measure(const Skeleton& skeleton, const Shoot& shoot) {
    ShootMeasure sum;
    for (std::size_t i = 1; i < shoot.count; ++i)
        sum.length += static_cast<double>(
            glm::distance(skeleton.shootPoint(shoot, i - 1), skeleton.shootPoint(shoot, i)));
    const auto base = static_cast<double>(shoot.baseRadius), tip = static_cast<double>(shoot.tipRadius);
    sum.volume = frustumVolume(sum.length, base, tip);
    sum.outline = (base + tip) * sum.length;
    for (std::size_t i = 1; i < shoot.count; ++i) {
        const glm::dvec3 along(skeleton.shootPoint(shoot, i) - skeleton.shootPoint(shoot, i - 1));
        const double length = glm::length(along);
        sum.upright += length > 0.0 ? along.z * along.z / length : 0.0;
    }
    return sum;
}

} // namespace

double frustumVolume(double length, double a, double b) {
    return glm::pi<double>() / 3.0 * length * (a * a + a * b + b * b);
}

double woodVolume(const Skeleton& skeleton) {
    double volume = 0.0;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        for (int ring = 1; ring < skeleton.ringsPerBranch; ++ring)
            volume += frustumVolume(static_cast<double>(glm::distance(skeleton.point(unit, ring - 1),
                                                                      skeleton.point(unit, ring))),
                                    static_cast<double>(skeleton.radius(unit, ring - 1)),
                                    static_cast<double>(skeleton.radius(unit, ring)));
    for (const Shoot& shoot : skeleton.shoots)
        volume += measure(skeleton, shoot).volume;
    return volume;
}

ShootWood ShootWood::scaled(const glm::vec3& axes, float radius) const {
    const float across = 0.5f * (axes.x * axes.x + axes.y * axes.y);
    const float longer = std::sqrt(glm::mix(across, axes.z * axes.z, upright));
    return {volume * longer * radius * radius, outline * longer * radius, upright};
}

std::vector<ShootWood> shootWoodOf(const Skeleton& skeleton) {
    if (skeleton.shoots.empty())
        return {};
    std::vector<ShootMeasure> sums(skeleton.units.size());
    for (const Shoot& shoot : skeleton.shoots) {
        const ShootMeasure one = measure(skeleton, shoot);
        ShootMeasure& sum = sums[static_cast<std::size_t>(shoot.unit)];
        sum.volume += one.volume;
        sum.outline += one.outline;
        sum.length += one.length;
        sum.upright += one.upright;
    }
    std::vector<ShootWood> wood;
    wood.reserve(sums.size());
    for (const ShootMeasure& sum : sums)
        wood.push_back({static_cast<float>(sum.volume), static_cast<float>(sum.outline),
                        sum.length > 0.0 ? static_cast<float>(sum.upright / sum.length) : 0.0f});
    return wood;
}

} // namespace osgTreeWind
