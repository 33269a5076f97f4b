// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/CriticalSpeeds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

TreeStrength strength(double uproot, double breaking) {
    TreeStrength tree;
    tree.uproot = uproot;
    tree.breaking = breaking;
    return tree;
}

} // namespace

TEST(CriticalSpeeds, AreFoundForLoadsThatArePowersOfTheWind) {
    for (const double power : {1.0, 1.6, 2.0}) {
        int storms = 0;
        const auto moment = [&](double speed) {
            ++storms;
            return 100.0 * std::pow(speed, power);
        };
        const CriticalSpeeds found = findCriticalSpeeds(moment, strength(moment(17.0), moment(43.0)));
        EXPECT_NEAR(found.uproot.value(), 17.0, 0.02) << power;
        EXPECT_NEAR(found.breaking.value(), 43.0, 0.02) << power;
        EXPECT_LE(storms, 9) << power;
    }
}

TEST(CriticalSpeeds, AreInterpolatedBetweenStorms) {
    const MomentsBySpeed storms{{10.0, 1e3}, {20.0, 4e3}, {40.0, 8e3}};
    EXPECT_NEAR(criticalSpeeds(storms, strength(2e3, 0.0)).uproot.value(), std::sqrt(200.0), 1e-9);
    EXPECT_NEAR(criticalSpeeds(storms, strength(6e3, 0.0)).uproot.value(), 30.0, 1e-9);
}

TEST(CriticalSpeeds, AreEmptyWithoutALimitOrAboveTheFastestWind) {
    const auto square = [](double speed) { return speed * speed; };
    const CriticalSpeeds found = findCriticalSpeeds(square, strength(0.0, 1e6));
    EXPECT_FALSE(found.uproot);
    EXPECT_FALSE(found.breaking);
    const CriticalSpeeds calm = findCriticalSpeeds([](double) { return 0.0; }, strength(1.0, 1.0));
    EXPECT_FALSE(calm.uproot);
}

} // namespace osgTreeWind
