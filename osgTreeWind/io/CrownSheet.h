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

/// Trees of a square of a tile, as they look from afar.
struct CrownCell {
    std::uint32_t column = 0, row = 0; ///< Of cells, from the corner of tile (0, 0).
    std::uint32_t trees = 0;
    float foot = 0.0f;       ///< Mean, metres in the world's frame.
    float height = 0.0f;     ///< Mean, metres.
    float width = 0.0f;      ///< Of a crown, so that all cover what they do: metres.
    std::size_t species = 0; ///< Of most trees: index into CrownSheet::species.
};

/// All trees of a world as they look from afar: CSV with a header, a row for each cell that has any.
struct CrownSheet {
    /// Of some 125 m, 1 to 8 on each side of a tile.
    static std::uint32_t cellsAcrossTile(const ForestTiles& tiles);

    std::vector<std::string> species; ///< Names.
    std::vector<CrownCell> cells;
};

/// @return all of it, or what is wrong, at which line. Thread-safe.
Result<CrownSheet> readCrownSheet(std::istream& input, const std::string& file);
std::string crownSheetHead();

/// The rows of one tile, from its trees in turn.
class CrownSums {
public:
    /// @param size of the tree as it stands.
    void add(const TreePlacement& tree, const TreeSize& size, const ForestTiles& tiles);
    /// @param species of the forest.
    std::string text(const std::vector<Species>& species) const;

private:
    struct Cell {
        double trees = 0.0, foot = 0.0, height = 0.0, squareWidth = 0.0;
        std::map<std::size_t, std::uint32_t> bySpecies;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Cell> _cells; ///< By row, column.
};

} // namespace osgTreeWind
