// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

#include <osgTreeWind/io/CrownSheet.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>

#include <numeric>

using namespace osgTreeWind;

namespace {

/// As a tile is written. @param trees whose species are those of the tile.
std::string rowsOf(const TileTrees& tile) {
    std::vector<Species> species(tile.species.size());
    for (std::size_t i = 0; i < species.size(); ++i)
        species[i].name = tile.species[i];
    std::vector<std::uint32_t> all(tile.trees.size());
    std::iota(all.begin(), all.end(), 0);
    return tileHead() + tileRows(tile.trees, all, species);
}

void expectTile(const std::string& text) {
    std::istringstream input(text);
    auto tile = readTileTrees(input, "fuzz");
    expectReason(tile);
    if (!tile)
        return;
    const std::string rows = rowsOf(tile.value());
    std::istringstream again(rows);
    const auto read = readTileTrees(again, "again");
    if (!read || rowsOf(read.value()) != rows)
        std::abort();
    const std::vector<Species> known(1);
    (void)tile.value().fit(known, tile.value().trees.size(), "fuzz");
}

} // namespace

/// All that a tile's server sends is one of these.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = textOf(data, size);
    expectTile(text);
    std::istringstream ids(text), sheet(text);
    expectReason(readTileIds(ids, "fuzz"));
    expectReason(readCrownSheet(sheet, "fuzz"));
    return 0;
}
