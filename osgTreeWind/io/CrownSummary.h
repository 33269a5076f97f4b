// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// Summary of the trees in one square cell of a tile, for drawing them from afar.
struct CrownCell {
    std::uint32_t column = 0, row = 0; ///< Index of the cell from the corner of tile (0, 0).
    std::uint32_t trees = 0;           ///< Number of trees.
    float foot = 0.0f;                 ///< Mean height of the feet, world z in metres.
    float height = 0.0f;               ///< Mean tree height, metres.
    float width = 0.0f;                ///< Root mean square of the crown widths, metres.
    std::size_t species = 0;           ///< Most frequent species; index into CrownSummary::species.
};

/// Summary of all trees of a tiled forest: a CSV file with a header and a row for each non-empty cell.
struct CrownSummary {
    /// Number of cells along a side of a tile, 1 to 8; a cell has about 125 m.
    static std::uint32_t cellsAcrossTile(const ForestTiles& tiles);

    std::vector<std::string> species; ///< Names.
    std::vector<CrownCell> cells;
};

/// Thread-safe. @param file name for diagnostics.
Result<CrownSummary> readCrownSummary(std::istream& input, const std::string& file);
std::string crownSummaryHeader();

/// Accumulates the cells of one tile from its trees.
class CrownAccumulator {
public:
    /// @param size of the scaled tree.
    void add(const TreePlacement& tree, const TreeSize& size, const ForestTiles& tiles);
    /// The rows of the CSV file. @param species of the forest.
    std::string text(const std::vector<Species>& species) const;

private:
    struct Cell {
        double trees = 0.0, foot = 0.0, height = 0.0, squaredWidth = 0.0;
        std::map<std::size_t, std::uint32_t> bySpecies;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Cell> _cells; ///< By row, column.
};

} // namespace osgTreeWind
