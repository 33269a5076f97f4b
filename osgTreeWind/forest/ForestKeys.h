// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<DrawingOptions>();
template <>
const Keys& keysOf<TreePlacement>();
/// The range of a field of TreePlacement.
inline const Range& treeRange(const std::string& key) {
    return keyAt(keysOf<TreePlacement>(), key).range;
}
template <>
const Keys& keysOf<EstimatedSizes>();
/// Keys of [motion], except for the noise.
template <>
const Keys& keysOf<ForestDescription>();
/// The word for a law in a file.
std::string wordOf(MotionLaw law);
/// Keys of ForestDescription in the root table of a file.
const Keys& forestFileKeys();

// Ranges of ForestDescription::gain, noiseExponent, season and step (seconds).
constexpr Range gains = within(0, 100), noiseExponents = within(0, 3), seasons = within(0, 4),
                frameSteps = within(0, 60);
constexpr std::size_t maxTrees = 1000000;
constexpr double maxTreeDistance = 100000.0; ///< From the origin, metres; floats still resolve 8 mm.
/// Ranges of ForestTiles: `size` and `range` in metres, columns and rows, and `idFiles`.
constexpr Range tileSizes = within(10, 100000), tileCounts = within(1, 10000),
                tileIdFiles = within(0, 100000);

std::vector<KeyConflict> conflictsOf(const DrawingOptions& drawing);

} // namespace osgTreeWind
