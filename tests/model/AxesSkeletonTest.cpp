// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/AxesSkeleton.h>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr double height = 16.0; // metres

/// Units of a straight trunk. @param radius by height.
std::vector<BranchUnit> trunkUnits(const std::function<double(double)>& radius) {
    constexpr double segment = 0.125;
    WoodAxis trunk;
    trunk.line.add(glm::dvec3(0.0));
    for (double z = 0.0; z < height; z += segment) {
        trunk.line.add({0.0, 0.0, z + segment});
        trunk.radii.push_back(radius(z + 0.5 * segment));
        trunk.volume += glm::pi<double>() * trunk.radii.back() * trunk.radii.back() * segment;
    }
    std::vector<WoodAxis> axes;
    axes.push_back(std::move(trunk));
    return makeSkeleton(std::move(axes), {}).skeleton.units;
}

/// Ratio of the bending compliance of the units, sliced, to that of the trunk, for a load at its top.
double complianceRatio(const std::vector<BranchUnit>& units, const std::function<double(double)>& radius) {
    constexpr double step = 1e-3;
    double own = 0.0, drawn = 0.0;
    for (const BranchUnit& unit : units) {
        const double from = static_cast<double>(unit.base.z), to = static_cast<double>(unit.tip.z);
        for (double z = from + 0.5 * step; z < to; z += step) {
            const double t = (z - from) / (to - from);
            const double arm = (height - z) * (height - z);
            drawn += arm / std::pow((1.0 - t) * static_cast<double>(unit.baseRadius) +
                                        t * static_cast<double>(unit.tipRadius),
                                    4.0);
            own += arm / std::pow(radius(z), 4.0);
        }
    }
    return drawn / own;
}

TEST(AxesSkeleton, ADividedTrunkIsAsStiffAsItsWood) {
    const auto divided = [](double z) { // limbs leave it from 9 to 10 m
        return 0.12 * std::pow(1.0 - z / height, 0.6) + 0.08 * glm::clamp(10.0 - z, 0.0, 1.0);
    };
    EXPECT_NEAR(complianceRatio(trunkUnits(divided), divided), 1.0, 0.1);
}

TEST(AxesSkeleton, ATrunkThatTapersToItsTopHasUnitsOfEqualLength) {
    const auto units = trunkUnits([](double z) { return 0.2 * std::pow(1.0 - z / height, 0.6); });
    for (const BranchUnit& unit : units)
        EXPECT_NEAR(unit.tip.z - unit.base.z, units.front().tip.z, 1e-4f);
}

} // namespace
} // namespace osgTreeWind
