// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TileWriter.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <utility>

namespace osgTreeWind {

namespace {

bool append(const std::string& path, const std::string& text) {
    return bool((std::ofstream(path, std::ios::binary | std::ios::app) << text).flush());
}

std::size_t tileAt(const ForestTiles& tiles, const glm::dvec3& place) {
    const glm::dvec2 cell =
        glm::floor(glm::dvec2(place) / tiles.size) - glm::round(tiles.corner / tiles.size);
    return static_cast<std::size_t>(cell.y) * tiles.columns + static_cast<std::size_t>(cell.x);
}

} // namespace

TileWriter::TileWriter(const ForestDescription& world, Executor executor)
    : _tiles(*world.tiles), _executor(std::move(executor)), _shapes(world), _crowns(_tiles.tiles.size()),
      _idFiles(_tiles.idFiles) {}

bool TileWriter::add(const std::vector<TreePlacement>& trees) {
    std::vector<std::vector<std::uint32_t>> byTile(_tiles.tiles.size());
    std::map<std::uint32_t, std::string> ids; // rows by file
    for (std::size_t i = 0; !_failed && i < trees.size(); ++i) {
        const std::size_t tile = tileAt(_tiles, trees[i].position);
        const std::string& name = trees[i].name;
        if (!name.empty()) {
            const std::uint32_t file = *idFileOf(_tiles, name);
            const std::size_t number = _tiles.tiles[tile].trees + byTile[tile].size();
            ids[file] += (_idFiles[file] ? "" : tileIdsHeader()) +
                         tileIdsRow(name, nameOfTile(_tiles, tile) + '/' + std::to_string(number));
            _idFiles[file] = true;
        }
        byTile[tile].push_back(static_cast<std::uint32_t>(i));
    }
    for (const auto& [file, text] : ids)
        _failed = _failed || !append(fileOfIds(_tiles, file), text);
    std::atomic<bool> failed = _failed;
    runJobs(_executor, byTile.size(), [&](std::size_t tile) {
        if (!failed && !byTile[tile].empty() && !addToTile(tile, trees, byTile[tile]))
            failed = true;
    });
    _failed = failed;
    return !_failed;
}

bool TileWriter::addToTile(std::size_t tile, const std::vector<TreePlacement>& all,
                           const std::vector<std::uint32_t>& trees) {
    ForestTiles::Tile& entry = _tiles.tiles[tile];
    const std::string header = entry.trees == 0 ? tileHeader() : std::string();
    for (const std::uint32_t index : trees) {
        const auto z = static_cast<float>(all[index].position.z);
        entry.low = entry.trees == 0 ? z : std::min(entry.low, z);
        entry.high = entry.trees == 0 ? z : std::max(entry.high, z);
        ++entry.trees;
        _crowns[tile].add(all[index], _shapes.sizeOf(_shapes.makePlacedTree(all[index])), _tiles);
    }
    return append(fileOfTile(_tiles, tile), header + tileRows(all, trees, _shapes.description().species));
}

bool TileWriter::finish() {
    std::string crowns = crownSummaryHeader();
    for (const CrownAccumulator& each : _crowns)
        crowns += each.text(_shapes.description().species);
    return !_failed && append(fileOfCrowns(_tiles), crowns);
}

} // namespace osgTreeWind
