// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/model/FormSkeleton.h>
#include <osgTreeWind/model/PalmTree.h>

#include <cstdint>

namespace osgTreeWind {

/// The units of a small tree grown by light, without shoots.
inline Skeleton sampleTree(std::uint32_t seed = 1, float flare = 0.0f) {
    GrowthParameters growth;
    growth.size = {8.0f, 0.25f, 5.0f};
    growth.seed = seed;
    Skeleton skeleton = makeSkeleton(growTree(growth));
    skeleton.shoots.clear();
    skeleton.shootPoints.clear();
    skeleton.leafyUnits.clear();
    skeleton.flare = flare;
    return skeleton;
}

/// A bare palm stem that tapers to three quarters of its radius.
inline PalmParameters barePole(float height) {
    PalmParameters pole;
    pole.height = height;
    pole.trunk = pole.crownBase = 1.0f;
    pole.fronds = 0;
    return pole;
}

} // namespace osgTreeWind
