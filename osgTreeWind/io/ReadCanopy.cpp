// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/forest/ClosedWood.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/ReadKeys.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <fstream>

namespace osgTreeWind {

namespace {

/// Whether the source of a wind cannot know the trees of the forest.
bool isOpenWind(const Wind& wind) {
    if (const WindFiles* files = filesOf(wind))
        return !files->mayIncludeTrees;
    const WindField* field = wind.field.get();
    return dynamic_cast<const UniformWind*>(field) || dynamic_cast<const TimeSeriesWind*>(field);
}

/// shareInClosedWood() of a world in tiles. Its summary tells the crowns in each cell, which are taken to
/// stand at random. 0 if it cannot be read.
double shareInClosedWood(const ForestTiles& tiles) {
    std::ifstream file(toPath(fileOfCrowns(tiles)));
    const Result<CrownSummary> crowns = readCrownSummary(file, fileOfCrowns(tiles));
    if (!crowns)
        return 0.0;
    const double side = tiles.size / CrownSummary::cellsAcrossTile(tiles);
    double closed = 0.0, all = 0.0;
    for (const CrownCell& cell : crowns.value().cells) {
        const double width = static_cast<double>(cell.width), trees = cell.trees;
        const double crownArea = 0.25 * glm::pi<double>() * width * width * trees / (side * side);
        all += trees;
        closed += 1.0 - math::exp(-crownArea) >= closedCover ? trees : 0.0;
    }
    return all > 0.0 ? closed / all : 0.0;
}

} // namespace

void readCanopy(TableReader& table, ForestDescription& forest, DocumentTrees& trees) {
    readKeys(table, forest.canopy);
    const bool mayDecide = !table.has("canopy") || table.hasText("canopy", "auto");
    if (!mayDecide || forest.law != MotionLaw::Modal || !isOpenWind(forest.wind) || !table.isDocumentValid())
        return;
    const double closed = forest.tiles
                              ? shareInClosedWood(*forest.tiles)
                              : shareInClosedWood(forest.species, trees.size(),
                                                  [&](const TreeVisitor& visitor) { trees.visit(visitor); });
    const bool isClosed = closed >= 0.5;
    if (isClosed)
        forest.canopy.source = CanopySource::Forest;
    if (closed > 0.0)
        table.note(std::to_string(std::lround(100.0 * closed)) + " % of the trees stand in a closed wood; " +
                   (isClosed ? "the trees change the wind, as with wind.canopy = \"forest\"; \"none\" gives "
                               "each the wind as it is"
                             : "the trees do not change the wind, as with wind.canopy = \"none\"; \"forest\" "
                               "lets them shelter each other"));
}

} // namespace osgTreeWind
