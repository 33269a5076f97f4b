// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/ReadKeys.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/places/HostMap.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace osgTreeWind {

std::string problemOfShapes(const ShapeFamilies& families, const std::vector<TreeCounts>& largest) {
    constexpr std::uint64_t maxVertices = 50000000;
    std::uint64_t vertices = 0;
    for (std::size_t i = 0; i < largest.size(); ++i)
        vertices += largest[i].totalVertices() * families.all()[i].shapes;
    if (vertices <= maxVertices)
        return {};
    return "the shapes of all species have " + std::to_string(vertices) + " vertices; at most " +
           std::to_string(maxVertices) +
           " are possible (fewer levels, children_per_branch, rings_per_branch, clusters_per_branch or "
           "shapes)";
}

void readVersion(TableReader& root) {
    int version = 0;
    root.require("version", version, within(1, 1));
}

namespace {

void readSearch(TableReader& root, InputFolders& folders) {
    std::vector<std::string> search;
    root.read("search", search);
    for (const std::string& folder : search)
        folders.add(pathIn(folders.ofDocument(), folder));
    if (const auto data = environmentVariable("OSGTREEWIND_DATA"))
        folders.add(*data);
}

void readSeason(TableReader& root, float& season) {
    std::string text;
    if (!root.readScalar("season", text))
        return;
    if (const std::optional<float> parsed = parseSeason(text))
        season = *parsed;
    else
        root.problem("season", expectedFound(seasonSyntax, text));
}

void readMotion(TableReader& table, ForestDescription& forest, float& leaves) {
    Keys keys = keysOf<ForestDescription>();
    if (table.hasText("law", "damped")) { // a law of version 1.0
        table.note("motion.law: \"damped\" no longer exists; it is read as \"modal\"");
        keys.front().words.emplace_back("damped", static_cast<int>(MotionLaw::Modal));
    }
    readKeys(table, keys, &forest);
    table.read("leaves", leaves, keyAt(keysOf<TreePlacement>(), "leaves").range);
    bool isFractal = false;
    const bool isKnown = table.readChoice<bool>("noise", isFractal, {{"perlin", false}, {"1/f", true}});
    float exponent = 1.0f;
    const bool isExponentGiven = table.read("noise_exponent", exponent, noiseExponents);
    if (isFractal)
        forest.noiseExponent = exponent;
    else if (isExponentGiven && (isKnown || !table.has("noise")))
        table.problem("noise_exponent", "expected noise = \"1/f\" with it");
}

/// Reads all [[species]]. Without them, the file declares one with default values.
void readAllSpecies(TableReader& root, const InputFolders& folders, DocumentSpecies& species) {
    if (!root.has("species")) {
        Species tree;
        tree.name = "tree";
        species.reserveName(tree.name);
        species.add(std::move(tree));
    }
    root.tables("species", [&](TableReader& table) { readSpecies(table, folders, species); });
    if (species.all().empty())
        root.problem("species", "expected at least one [[species]]");
    species.endDeclared(root.has("species"));
}

/// Removes the default species if all trees are of built-in species.
void removeUnusedDefault(std::vector<Species>& species, DocumentTrees& trees) {
    const TreeBounds& bounds = trees.bounds();
    if (species.size() == 1 || bounds.inForest.count(0) > 0 || bounds.inOpen.count(0) > 0)
        return;
    species.erase(species.begin());
    trees.modify([](TreeSpool::Trees& some, const std::vector<std::size_t>&) {
        for (TreePlacement& tree : some)
            --tree.species;
    });
}

/// (0, 0, 0) if all trees are near it, or else their centre rounded to metres, at the lowest foot.
glm::dvec3 defaultOrigin(const TreeBounds& trees) {
    constexpr double near = 10000.0;
    if (glm::length(glm::max(glm::abs(trees.low), glm::abs(trees.high))) < near)
        return glm::dvec3(0.0);
    const glm::dvec3 centre = 0.5 * (trees.low + trees.high);
    return {std::round(centre.x), std::round(centre.y), std::floor(trees.low.z)};
}

void readOrigin(TableReader& root, const SceneMap& map, DocumentTrees& trees, ForestDescription& forest) {
    std::vector<double> origin;
    if (root.readNumbers("origin", origin, 3, 3, worldCoordinates))
        forest.origin = map.toScene({origin[0], origin[1], origin[2]});
    else if (forest.tiles)
        root.problem("origin", "missing: [tiles] needs it");
    else
        forest.origin = defaultOrigin(trees.bounds());
    const glm::dvec3 low = trees.bounds().low - forest.origin, high = trees.bounds().high - forest.origin;
    if (glm::length(glm::max(glm::abs(low), glm::abs(high))) <= maxTreeDistance)
        return;
    std::optional<glm::dvec3> first;
    trees.visit([&](const TreeSpool::Trees& some) {
        for (const TreePlacement& tree : some)
            if (!first && glm::distance(tree.position, forest.origin) > maxTreeDistance)
                first = tree.position;
    });
    if (first && root.isDocumentValid()) // otherwise an inventory may have reported the row
        root.problem("origin", "a tree at (" + numberText(first->x) + ", " + numberText(first->y) + ", " +
                                   numberText(first->z) + ") is more than 100 km from the origin");
}

} // namespace

void readRoot(TableReader& root, ForestReading& reading) {
    const InputFolders& folders = reading.folders;
    const TreeDefaults& defaults = reading.defaults;
    ForestDescription& forest = reading.forest;
    SceneMap& map = reading.map;
    DocumentSpecies& species = reading.species;
    DocumentTrees& trees = reading.trees;

    readVersion(root);
    root.read("seed", reading.defaults.seed);
    readSearch(root, reading.folders);
    readKeys(root, forestFileKeys(), &forest);
    map.read(root);
    readSeason(root, forest.season);
    root.table("motion", [&](TableReader& table) { readMotion(table, forest, reading.defaults.leaves); });
    root.table("drawing", [&](TableReader& table) {
        readKeys(table, forest.drawing);
        reportConflicts(table, conflictsOf(forest.drawing));
    });
    readAllSpecies(root, folders, species);
    root.tables("tree", [&](TableReader& table) { readTree(table, defaults, species, trees); });
    root.tables("scatter", [&](TableReader& table) { readScatter(table, defaults, map, species, trees); });
    const auto findGround = [&]() -> GroundPtr {
        ReadLog unused; // [ground] is read again below
        unused.settings = reading.log.settings;
        std::optional<RasterGround::Source> source;
        TableReader::readDocument(reading.forest.source, unused, [&](TableReader& document) {
            document.ignoreRest();
            document.table("ground", [&](TableReader& table) { source = readGroundSource(table, folders); });
        });
        const auto ground = source ? RasterGround::open(*source, map.crs()) : Diagnostics();
        return ground ? ground.value() : nullptr;
    };
    root.tables("inventory", [&](TableReader& table) {
        readInventory(table, folders, defaults, map, species, trees, findGround);
    });
    root.table("tiles", [&](TableReader& table) { forest.tiles = readTiles(table, folders, species); });
    if (!root.has("tree") && !root.has("scatter") && !root.has("inventory") && !root.has("tiles"))
        root.problem("", "no trees: expected [[tree]], [scatter], [inventory] or [tiles]");
    if (forest.tiles && forest.law != MotionLaw::Modal)
        root.problem("tiles", "expected the law \"modal\" with tiles");

    if (!root.has("species"))
        removeUnusedDefault(forest.species, trees);
    map.reproject(trees, root);
    std::optional<ShapeFamilies> families;
    std::vector<TreeCounts> largest; // by family
    if (root.isDocumentValid()) {
        trees.findGrowingSpaces(forest);
        largest = families.emplace(forest).countLargest();
        trees.varyNeighbourSeeds(forest, *families);
        if (const std::string problem = problemOfShapes(*families, largest); !problem.empty())
            root.problem("species", problem);
    }
    root.table("ground", [&](TableReader& table) { readGround(table, folders, forest, map, trees); });
    if (!forest.ground)
        noteFeetWithoutGround(root, trees);
    if (root.isDocumentValid())
        if (const std::string problem = problemOfMemory(forest, *families, largest); !problem.empty())
            root.problem("", problem);
    readOrigin(root, map, trees, forest);
    if (!forest.hostCrs.empty())
        if (const auto place = hostMapTransform(forest.crs, forest.origin, forest.hostCrs); !place)
            root.problem("host_crs", place.problems().front().message);
    root.table("wind", [&](TableReader& table) {
        forest.wind = readWind(table, folders, forest, map, trees, defaults.seed);
        readCanopy(table, forest, trees);
    });
}

} // namespace osgTreeWind
