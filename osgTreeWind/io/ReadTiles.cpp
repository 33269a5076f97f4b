// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/system/Path.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

using Rows = std::vector<std::vector<double>>;

/// Reads an array with a row for each row of tiles.
bool readGrid(TableReader& table, const std::string& key, std::size_t columns, std::size_t rows,
              const Range& range, Rows& values) {
    if (!table.has(key))
        return table.reportMissing(key);
    if (!table.readRows(key, values, columns, range))
        return false;
    if (values.size() != rows)
        table.problem(key, "expected " + std::to_string(rows) + " rows, as `trees` has");
    return values.size() == rows;
}

bool readTileGrid(TableReader& table, ForestTiles& tiles) {
    int columns = 0, rows = 0;
    Rows trees, low, high;
    if (!table.require("columns", columns, tileCounts) || !table.require("rows", rows, tileCounts))
        return false;
    tiles.columns = static_cast<std::uint32_t>(columns);
    const auto width = static_cast<std::size_t>(columns), length = static_cast<std::size_t>(rows);
    if (!readGrid(table, "trees", width, length, within(0, 4e9), trees) ||
        !readGrid(table, "low", width, length, worldCoordinates, low) ||
        !readGrid(table, "high", width, length, worldCoordinates, high))
        return false;
    for (std::size_t row = 0; row < length; ++row)
        for (std::size_t column = 0; column < width; ++column)
            tiles.tiles.push_back({static_cast<std::uint32_t>(trees[row][column]),
                                   static_cast<float>(low[row][column]),
                                   static_cast<float>(high[row][column])});
    return true;
}

std::vector<std::string> readNames(TableReader& table, const DocumentSpecies& species,
                                   const std::string& key) {
    std::vector<std::string> names;
    if (table.has(key) && !table.hasArray(key))
        table.problem(key, "expected an array of names");
    else if (table.read(key, names))
        for (const std::string& name : names)
            if (!species.find(name))
                table.problem(key, "no [[species]] " + inQuotes(name));
    return names;
}

std::string inFolder(const std::string& folder, const std::string& name) {
    if (name.find("://") != std::string::npos)
        return name;
    if (folder.find("://") != std::string::npos)
        return folder + '/' + name;
    return pathIn(folder, name);
}

template <typename Value>
void writeGrid(std::ostream& output, const char* key, const ForestTiles& tiles, const Value& value) {
    output << key << " = [\n";
    for (std::size_t row = 0; row < tiles.rows(); ++row) {
        std::vector<float> values;
        for (std::size_t column = 0; column < tiles.columns; ++column)
            values.push_back(static_cast<float>(value(tiles.tiles[row * tiles.columns + column])));
        output << "    " << tomlText(values) << ",\n";
    }
    output << "]\n";
}

} // namespace

std::optional<ForestTiles> readTiles(TableReader& table, const InputFolders& folders,
                                     const DocumentSpecies& species) {
    ForestTiles tiles;
    std::string folder = "tiles";
    table.read("folder", folder);
    tiles.folder = inFolder(folders.ofDocument(), folder);
    std::string problem = folders.problemOfName(folder);
    if (std::error_code error; problem.empty() && std::filesystem::exists(toPath(tiles.folder), error))
        problem = folders.problemOfTrust(tiles.folder);
    if (!problem.empty())
        table.problem("folder", inQuotes(folder) + ' ' + problem);
    table.require("size", tiles.size, tileSizes);
    table.require("range", tiles.range, tileSizes);
    std::vector<double> corner;
    if (table.readNumbers("corner", corner, 2, 2, worldCoordinates))
        tiles.corner = {corner[0], corner[1]};
    else
        table.reportMissing("corner");
    tiles.inForest = readNames(table, species, "in_forest");
    tiles.inOpen = readNames(table, species, "in_open");
    int idFiles = 0;
    if (table.read("id_files", idFiles, tileIdFiles))
        tiles.idFiles = static_cast<std::uint32_t>(idFiles);
    if (std::vector<std::string> removed; table.read("removed", removed))
        tiles.removed.insert(removed.begin(), removed.end());
    return readTileGrid(table, tiles) ? std::optional(std::move(tiles)) : std::nullopt;
}

void writeTiles(std::ostream& output, const ForestTiles& tiles) {
    output << "\n[tiles]\nfolder = " << tomlText(tiles.folder) << "\nsize = " << tomlText(tiles.size)
           << "\ncorner = " << tomlText(std::vector<double>{tiles.corner.x, tiles.corner.y})
           << "\nrange = " << tomlText(tiles.range) << "\nin_forest = " << tomlText(tiles.inForest)
           << "\nin_open = " << tomlText(tiles.inOpen);
    if (tiles.idFiles > 0)
        output << "\nid_files = " << std::to_string(tiles.idFiles);
    if (!tiles.removed.empty())
        output << "\nremoved = "
               << tomlText(std::vector<std::string>(tiles.removed.begin(), tiles.removed.end()));
    output << "\ncolumns = " << std::to_string(tiles.columns) << "\nrows = " << std::to_string(tiles.rows())
           << '\n';
    using Tile = ForestTiles::Tile;
    writeGrid(output, "trees", tiles, [](const Tile& tile) { return tile.trees; });
    writeGrid(output, "low", tiles, [](const Tile& tile) { return tile.low; });
    writeGrid(output, "high", tiles, [](const Tile& tile) { return tile.high; });
}

} // namespace osgTreeWind
