// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/growth/GrowthKeys.h>

#include <glm/trigonometric.hpp>

#include <string>
#include <vector>

namespace osgTreeWind {

/// A spruce: whorls, sinking boughs, hanging branchlets.
inline TreeHabit spruceHabit() {
    TreeHabit h;
    h.annualShoot = {0.42f, 0.17f, 0.24f, 0.16f};
    h.internode = {0.21f, 0.23f, 0.2f, 0.16f};
    h.halfVigour = {300, 60, 25, 6};
    h.rounding = 0.1f;
    h.deepest = 3;
    h.budsPerNode = 2;
    h.divergence = glm::radians(180.0f);
    h.branchAngle = {glm::radians(65.0f), glm::radians(50.0f), glm::radians(45.0f), glm::radians(40.0f)};
    h.flat = {0, 0.6f, 0.3f, 0.3f};
    h.whorl = 5;
    h.betweenWhorls = 0.9f;
    h.acrotony = 0;
    h.budLife = 4;
    h.apicalControl = {0.55f, 0.53f, 0.5f, 0.5f};
    h.apicalControlOld = 0.54f;
    h.forking = {0, 0, 0, 0};
    h.rise = {3, 0.25f, -0.2f, -0.5f};
    h.levelling = {0, 0.3f, 0.2f, 0};
    h.lightSeeking = {0, 0.15f, 0.1f, 0.1f};
    h.wander = {0.02f, 0.06f, 0.1f, 0.12f};
    h.sink = {0, glm::radians(55.0f), glm::radians(15.0f), 0};
    h.hang = {0, glm::radians(10.0f), glm::radians(120.0f), glm::radians(150.0f)};
    h.leafArea = 0.3f;
    h.leafYears = 6;
    h.lightNeed = 0.07f;
    h.deadYears = 15;
    h.cleanStem = 0.05f;
    h.twigRadius = 0.0015f;
    return h;
}

/// An oak: the trunk divides into crooked limbs.
inline TreeHabit oakHabit() {
    TreeHabit h;
    h.annualShoot = {0.5f, 0.24f, 0.32f, 0.28f};
    h.internode = {0.3f, 0.26f, 0.24f, 0.22f};
    h.halfVigour = {300, 25, 15, 8};
    h.rounding = 0.85f;
    h.branchAngle = {glm::radians(75.0f), glm::radians(55.0f), glm::radians(52.0f), glm::radians(50.0f)};
    h.budLife = 8;
    h.trunkTop = 0.4f;
    h.limbs = 5;
    h.forking = {0.03f, 0.12f, 0.15f, 0.15f};
    h.rise = {1.2f, 0.08f, 0.05f, 0.03f};
    h.wander = {0.12f, 0.4f, 0.45f, 0.45f};
    h.leafArea = 0.6f;
    h.lightNeed = 0.16f;
    h.cleanStem = 0.14f;
    return h;
}

/// A random habit; every number is within its range.
inline TreeHabit anyHabit(std::uint32_t seed) {
    Random random(seed);
    GrowthParameters growth;
    const auto any = [&](const Range& range) {
        const float u = random.uniform();
        const double share = u < 0.1f ? 0.0 : u > 0.9f ? 1.0 : static_cast<double>(random.uniform());
        return range.min + share * (range.max - range.min);
    };
    for (const Key& key : keysOf<GrowthParameters>()) {
        const Member member = key.member(&growth);
        const Range range = memberRange(key);
        if (const auto* whole = std::get_if<int*>(&member))
            **whole = static_cast<int>(any(range));
        else if (const auto* one = std::get_if<float*>(&member))
            **one = static_cast<float>(any(range));
        else if (const auto* some = std::get_if<std::array<float, 4>*>(&member))
            for (float& each : **some)
                each = static_cast<float>(any(range));
    }
    return growth.habit;
}

} // namespace osgTreeWind
