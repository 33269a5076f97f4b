// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>

#include <numeric>

using namespace osgTreeWind;

namespace {

/// Writes a tile as text.
std::string tileText(const TileTrees& tile) {
    std::vector<Species> species(tile.species.size());
    for (std::size_t i = 0; i < species.size(); ++i)
        species[i].name = tile.species[i];
    std::vector<std::uint32_t> all(tile.trees.size());
    std::iota(all.begin(), all.end(), 0);
    return tileHeader() + tileRows(tile.trees, all, species);
}

void expectTile(const std::string& text) {
    std::istringstream input(text);
    auto tile = readTileTrees(input, "fuzz");
    expectErrorHasMessage(tile);
    if (!tile)
        return;
    const std::string rows = tileText(tile.value());
    std::istringstream again(rows);
    const auto read = readTileTrees(again, "again");
    if (!read || tileText(read.value()) != rows)
        std::abort();
    const std::vector<Species> known(1);
    (void)tile.value().resolve(known, tile.value().trees.size(), "fuzz");
}

} // namespace

/// The answer of a tile server is one of these.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = textOf(data, size);
    expectTile(text);
    std::istringstream ids(text), sheet(text);
    expectErrorHasMessage(readTileIds(ids, "fuzz"));
    expectErrorHasMessage(readCrownSummary(sheet, "fuzz"));
    return 0;
}
