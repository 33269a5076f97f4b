// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<DrawingOptions>();
template <>
const Fields& fieldsOf<TreePlacement>();
/// Of what a tree says.
inline const Range& treeRange(const std::string& key) {
    return fieldAt(fieldsOf<TreePlacement>(), key).range;
}
template <>
const Fields& fieldsOf<EstimatedSizes>();
/// Of [motion], but for the noise.
template <>
const Fields& fieldsOf<ForestDescription>();
/// Of a law, in a file.
std::string wordOf(MotionLaw law);
/// Of a ForestDescription: what a file says of it in no table.
const Fields& fieldsOfFile();

/// Of ForestDescription::gain and noiseExponent.
constexpr Range gains = within(0, 100), noiseExponents = within(0, 3);
/// Of ForestDescription::season.
constexpr Range seasons = within(0, 4);
/// Of ForestDescription::step, seconds.
constexpr Range frameSteps = within(0, 60);
constexpr std::size_t mostTrees = 1000000;
constexpr double farthestTree = 100000.0; ///< From the origin, metres: floats still resolve 8 mm.
/// Of ForestTiles: metres of `size` and `range`, columns or rows, and `idFiles`.
constexpr Range tileSizes = within(10, 100000), tilesInARow = within(1, 10000),
                tileIdFiles = within(0, 100000);

std::vector<FieldConflict> conflictsOf(const DrawingOptions& drawing);

} // namespace osgTreeWind
