// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TiledForest.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/forest/ClosedWood.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/FlightPath.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>
#include <osgTreeWind/io/TreeBounds.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/system/FolderLock.h>
#include <osgTreeWind/system/Path.h>

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

constexpr double maxTiles = 10000.0, maxDefaultSize = 1000.0, defaultTreesPerTile = 2000.0,
                 idsPerFile = 5000.0;
constexpr std::size_t maxCanopyTrees = 20000;

/// Empty tiles that cover all trees, with corners at multiples of their size.
ForestTiles makeTileGrid(const TreeBounds& all, double size) {
    const glm::dvec2 low(all.low), high(all.high);
    const auto count = [&](int axis, double side) {
        return std::floor(high[axis] / side) - std::floor(low[axis] / side) + 1.0;
    };
    const bool isSizeGiven = size > 0.0;
    if (!isSizeGiven)
        size = maxDefaultSize;
    while (count(0, size) * count(1, size) > maxTiles)
        size *= 2.0;
    const auto trees = static_cast<double>(all.count);
    while (!isSizeGiven && trees > defaultTreesPerTile * count(0, size) * count(1, size) &&
           count(0, 0.5 * size) * count(1, 0.5 * size) <= maxTiles)
        size *= 0.5;
    ForestTiles tiles;
    tiles.size = size;
    tiles.corner = size * glm::floor(low / size);
    tiles.columns = static_cast<std::uint32_t>(count(0, size));
    tiles.tiles.resize(static_cast<std::size_t>(count(0, size) * count(1, size)));
    return tiles;
}

bool append(const std::string& path, const std::string& text) {
    return bool((std::ofstream(toPath(path), std::ios::binary | std::ios::app) << text).flush());
}

std::size_t tileAt(const ForestTiles& tiles, const glm::dvec3& place) {
    const glm::dvec2 cell =
        glm::floor(glm::dvec2(place) / tiles.size) - glm::round(tiles.corner / tiles.size);
    return static_cast<std::size_t>(cell.y) * tiles.columns + static_cast<std::size_t>(cell.x);
}

/// Writes the files of a tiled forest from batches of trees.
class TileWriter {
public:
    /// @param world without trees, with empty tiles in a folder that has no files of them.
    TileWriter(const ForestDescription& world, Executor executor)
        : _tiles(*world.tiles), _executor(std::move(executor)), _shapes(world), _crowns(_tiles.tiles.size()),
          _idFiles(_tiles.idFiles) {}

    /// The tiles, with counts and heights of the trees so far.
    const ForestTiles& tiles() const { return _tiles; }
    const PlacedForest& shapes() const { return _shapes; }

    /// Writes a batch of trees. @return false if a file cannot be written.
    bool add(const std::vector<TreePlacement>& trees) {
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

    /// Completes the files after the last batch. @return false if a file cannot be written.
    bool finish() {
        std::string crowns = crownSummaryHeader();
        for (const CrownAccumulator& each : _crowns)
            crowns += each.text(_shapes.description().species);
        return !_failed && append(fileOfCrowns(_tiles), crowns);
    }

private:
    bool addToTile(std::size_t tile, const std::vector<TreePlacement>& all,
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

    ForestTiles _tiles;
    Executor _executor;
    PlacedForest _shapes;
    std::vector<CrownAccumulator> _crowns; ///< Per tile.
    std::vector<bool> _idFiles;            ///< Whether the file has a header.
    bool _failed = false;
};

/// Computes the canopy statistics from all trees, or in large forests from every n-th tile.
CanopySettings computeTiledCanopy(const TileWriter& written, const Executor& executor,
                                  std::atomic<bool>& failed) {
    const PlacedForest& shapes = written.shapes();
    const ForestTiles& all = written.tiles();
    const std::size_t stride = (all.treeCount() + maxCanopyTrees - 1) / maxCanopyTrees;
    std::vector<std::size_t> tiles;
    for (std::size_t tile = 0, count = 0; tile < all.tiles.size(); ++tile)
        if (all.tiles[tile].trees > 0 && count++ % stride == 0)
            tiles.push_back(tile);
    std::vector<std::vector<CanopyTree>> stands(tiles.size());
    runJobs(executor, tiles.size(), [&](std::size_t i) {
        const Result<std::vector<TreePlacement>> trees =
            readTile(shapes.description().species, all, tiles[i]);
        if (!trees)
            failed = true;
        for (std::size_t j = 0; trees && j < trees.value().size(); ++j) {
            stands[i].emplace_back(shapes, shapes.makePlacedTree(trees.value()[j]));
        }
    });
    for (std::size_t i = 1; stride == 1 && i < stands.size(); ++i) // all trees are one stand
        std::move(stands[i].begin(), stands[i].end(), std::back_inserter(stands[0]));
    if (stride == 1)
        stands.resize(1);
    return withCanopyStatistics(shapes.description().canopy, stands, all.treeCount());
}

/// The folder of a tiled forest while it is written. A lock excludes other processes.
class WorldFolder {
public:
    explicit WorldFolder(const std::string& folder)
        : _folder(folder), _file(folder + "/world.treewind"), _lock(made(folder)) {}

    const std::string& file() const { return _file; }

    /// Creates an empty folder for new tiles, beside existing ones.
    Diagnostics begin() {
        if (!_lock.problem().empty())
            return {fileProblem(_folder, "cannot be written: " + _lock.problem())};
        if (!_lock.isHeld())
            return {fileProblem(_folder, "another program is writing a world into it")};
        std::error_code error;
        if (fs::exists(toPath(_file), error)) {
            const auto world = readForestFile(_file);
            if (!world || !world.value().tiles)
                return {fileProblem(_file, "expected a world or nothing there, found something else; remove "
                                           "it, or choose another folder")};
            _old = toPath(world.value().tiles->folder).lexically_normal();
        }
        const std::string first = toText(toPath(_folder) / "tiles"), second = first + "-2";
        _tiles = fs::equivalent(_old, toPath(first), error) ? second : first;
        for (const std::string& name : {first, second})
            if (!fs::equivalent(_old, toPath(name), error))
                if (Diagnostics problems = remove(name); !problems.empty())
                    return problems;
        if (!fs::create_directories(toPath(_tiles), error))
            return {fileProblem(_tiles, "cannot be created: " + error.message())};
        _new.emplace(_tiles);
        return {};
    }
    const std::string& tiles() const { return _tiles; }

    /// Keeps the new tiles and removes the old ones.
    void commit() {
        _new->keep();
        std::error_code error;
        if (fs::equivalent(_old.parent_path(), toPath(_tiles).parent_path(), error))
            remove(toText(_old));
    }

private:
    static const std::string& made(const std::string& folder) {
        std::error_code ignored;
        fs::create_directories(toPath(folder), ignored);
        return folder;
    }

    /// Removes a folder of tiles; fails if it contains other files.
    static Diagnostics remove(const std::string& name) {
        std::error_code error, ignored;
        const fs::path folder = toPath(name);
        if (!fs::is_directory(folder, error))
            return fs::exists(folder, error)
                       ? Diagnostics{fileProblem(name, "expected a folder of tiles or nothing")}
                       : Diagnostics();
        for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
            const fs::path extension = file->path().extension();
            if (extension != ".trees" && extension != ".crowns" && extension != ".ids" &&
                extension != ".part")
                return {fileProblem(name, "expected nothing but tiles in it, found " +
                                              toText(file->path().filename()))};
        }
        fs::remove_all(folder, ignored);
        return {};
    }

    std::string _folder, _file, _tiles;
    fs::path _old;
    FolderLock _lock;
    std::optional<TemporaryPath> _new;
};

/// @param forest without trees. @param visit visits all trees; false on an error.
Result<ForestTiles> writeWorld(ForestDescription forest, const std::function<bool(const TreeVisitor&)>& visit,
                               const std::string& folder, const TilingOptions& options) {
    TreeBounds all;
    bool isComplete = visit([&](const std::vector<TreePlacement>& trees) { all.add(trees); });
    if (isComplete && all.count == 0)
        return keyProblem({}, "there are no trees to cut into tiles");
    WorldFolder world(folder);
    if (Diagnostics problems = world.begin(); !problems.empty())
        return problems;
    ForestTiles& tiles = forest.tiles.emplace(makeTileGrid(all, options.size));
    tiles.folder = world.tiles();
    all.addSpeciesNames(forest.species, tiles);
    tiles.idFiles = static_cast<std::uint32_t>(
        std::min(std::ceil(static_cast<double>(all.named) / idsPerFile), maxTiles));
    const Executor executor = options.executor ? options.executor : Executor(runInTurn);
    TileWriter writer(forest, executor);
    isComplete = isComplete && visit([&](const std::vector<TreePlacement>& trees) { writer.add(trees); });
    std::atomic<bool> failed = !writer.finish() || !isComplete;
    tiles = writer.tiles();
    tiles.range = options.range > 0.0 ? options.range : defaultTileRange(tiles);
    if (!failed)
        forest.canopy = computeTiledCanopy(writer, executor, failed);
    if (failed)
        return AtomicFile(fileOfCrowns(tiles)).problem();
    Diagnostics problems = writeFileAtomically(folder + "/fly.path", makeFlightPath(tiles, forest.origin));
    ForestTiles result = tiles;
    tiles.folder = toText(toPath(tiles.folder).filename());
    if (problems.empty())
        problems = writeForestFile(forest, world.file());
    if (!problems.empty())
        return problems;
    world.commit();
    return result;
}

} // namespace

Result<ForestTiles> writeTiledForest(const ForestDescription& forest, const std::string& folder,
                                     const TilingOptions& options) {
    if (Diagnostics problems = check(forest); !problems.empty())
        return problems;
    ForestDescription world = forest;
    world.trees.clear();
    const auto visit = [&](const TreeVisitor& visitor) {
        visitor(forest.trees);
        return true;
    };
    return writeWorld(std::move(world), visit, folder, options);
}

Result<ForestTiles> writeTiledForest(const ForestStream& forest, const std::string& folder,
                                     const TilingOptions& options) {
    return writeWorld(
        forest.file(), [&](const TreeVisitor& visitor) { return forest.visit(visitor); }, folder, options);
}

} // namespace osgTreeWind
