// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/GroundPlacer.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// The paths of `file`, which is one name or an array of tiles. Empty after a problem.
std::vector<std::string> findFiles(TableReader& table, const InputFolders& folders) {
    std::vector<std::string> names(1), paths;
    if (table.hasArray("file") ? !table.read("file", names) : !table.require("file", names.front()))
        return {};
    if (names.empty())
        table.problem("file", "expected at least one file");
    for (const std::string& name : names)
        if (const auto file = folders.open(table, "file", name))
            paths.push_back(file->path);
    return paths.size() == names.size() ? paths : std::vector<std::string>();
}

/// How far the heights of an inventory's trees are off the ground.
class HeightCheck {
public:
    explicit HeightCheck(const InventoryHeights& heights) : _heights(heights) {}

    void add(const TreePlacement& tree, double ground) {
        const double offset = std::abs(tree.position.z - ground);
        _isOff += offset > maxOffset && offset > maxShare * static_cast<double>(tree.size.height);
        _offsets.push_back(offset);
    }

    void report(TableReader& table) {
        if (_offsets.empty())
            return;
        const auto middle = _offsets.begin() + static_cast<std::ptrdiff_t>(_offsets.size() / 2);
        std::nth_element(_offsets.begin(), middle, _offsets.end());
        const double largest = *std::max_element(middle, _offsets.end());
        const auto metres = [](double offset) {
            return numberText(std::round(100.0 * offset) / 100.0) + " m";
        };
        const std::string count = std::to_string(_offsets.size()) + " trees ",
                          howFar = metres(*middle) + " in the median and " + metres(largest) + " at most";
        if (2 * _isOff > _offsets.size())
            table.report(fileProblem(
                _heights.file, "the z of " + std::to_string(_isOff) + " of " + count +
                                   "is far off the ground, by " + howFar +
                                   "; set inventory.z = \"ignore\" if it does not count, \"height\" if "
                                   "it is the height of the tree, or \"top\" if it is that of its top"));
        else if (largest > 0.005)
            table.note(_heights.file + ": the z of " + count + "is off the ground by " + howFar +
                       " (inventory.z = \"ignore\" puts them on it)");
    }

private:
    static constexpr double maxOffset = 3.0, maxShare = 0.1; // metres; share of a tree's height

    const InventoryHeights& _heights;
    std::vector<double> _offsets;
    std::size_t _isOff = 0;
};

void checkHeights(TableReader& table, const Ground& ground, DocumentTrees& trees) {
    for (const InventoryHeights& heights : trees.inventoryHeights) {
        HeightCheck check(heights);
        trees.visitFeet(heights, [&](const TreePlacement& tree) {
            if (const auto height = heightOf(ground, glm::dvec2(tree.position)))
                check.add(tree, *height);
        });
        check.report(table);
    }
}

void putTreesOnGround(TableReader& table, const ForestDescription& read, DocumentTrees& trees) {
    ForestDescription forest;
    forest.species = read.species;
    forest.ground = read.ground;
    forest.tiles = read.tiles ? *read.tiles : ForestTiles();
    trees.bounds().addSpeciesNames(forest.species, *forest.tiles);
    GroundPlacer placer(forest);
    trees.modify([&](TreeSpool::Trees& some, const std::vector<std::size_t>& onGround) {
        placer.place(some, onGround);
    });
    const std::string advice = trees.adviceToExchange(
        [&](const glm::dvec2& place) { return heightOf(*read.ground, place).has_value(); });
    Diagnostics problems = placer.problems();
    if (problems.empty() && !advice.empty())
        problems = {keyProblem("file", "no ground below the trees of an inventory")};
    for (const Diagnostic& problem : problems)
        table.problem("file", problem.message + advice);
}

} // namespace

void noteFeetWithoutGround(TableReader& table, DocumentTrees& trees) {
    for (const InventoryHeights& heights : trees.inventoryHeights) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        if (heights.isAssumed)
            trees.visitFeet(heights, [&](const TreePlacement& tree) {
                low = std::min(low, tree.position.z);
                high = std::max(high, tree.position.z);
            });
        if (low < high)
            table.note(heights.file + ": the z of places is taken as the height of feet, " +
                       rangeText(low, high) +
                       " m, without a ground to compare; inventory.z sets another meaning");
    }
}

std::optional<RasterGround::Source> readGroundSource(TableReader& table, const InputFolders& folders) {
    bool none = false;
    const bool isRead = table.read("none", none);
    const bool isConflict = none && (table.has("file") || table.has("crs"));
    if (isConflict)
        table.problem("none", "cannot be combined with file or crs");
    if (isConflict || (table.has("none") && !isRead))
        table.ignoreRest();
    if (isConflict || (table.has("none") && !isRead) || none)
        return std::nullopt;
    RasterGround::Source source;
    table.read("crs", source.crs);
    if (int number = 0; !table.readScalar("band", source.band) && table.has("band"))
        if (table.read("band", number, within(1, 65535)))
            source.band = std::to_string(number);
    source.files = findFiles(table, folders);
    return source.files.empty() ? std::nullopt : std::optional(source);
}

void readGround(TableReader& table, const InputFolders& folders, ForestDescription& forest, SceneMap& map,
                DocumentTrees& trees) {
    const auto source = readGroundSource(table, folders);
    if (!source)
        return;
    auto ground = RasterGround::open(*source, map.crs());
    if (ground && ground.value()->map() && !map.crs()) {
        map.set(*ground.value()->map());
        map.reproject(trees, table);
        if (map.isReprojected())
            ground = RasterGround::open(*source, map.crs());
    }
    if (!ground) {
        const Diagnostic& problem = ground.problems().front();
        return problem.file.empty() ? table.problem(problem.key, problem.message) : table.report(problem);
    }
    forest.ground = ground.value();
    if (table.isDocumentValid()) {
        checkHeights(table, *forest.ground, trees);
        putTreesOnGround(table, forest, trees);
    }
}

std::string writeGround(std::ostream& output, const ForestDescription& forest) {
    if (!forest.ground)
        return {};
    const auto rasters = dynamic_cast<const RasterGround*>(forest.ground.get());
    if (!rasters)
        return "this ground cannot be written to a file: expected one from files, not a callable";
    std::vector<std::string> files;
    for (const std::string& file : rasters->source().files) {
        if (std::string problem = problemOfFile(file); !problem.empty())
            return problem;
        files.push_back(absolutePath(file));
    }
    output << "\n[ground]\nfile = " << tomlText(files) << '\n';
    if (const std::string& crs = rasters->source().crs; !crs.empty())
        output << "crs = " << tomlText(crs) << '\n';
    if (const std::string& band = rasters->source().band; !band.empty())
        output << "band = " << tomlText(band) << '\n';
    return {};
}

} // namespace osgTreeWind
