// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/output/Json.h>
#include <examples/osgtreewind/output/Progress.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/system/Path.h>

#include <glm/common.hpp>

#include <charconv>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

namespace {

using namespace osgTreeWind;

/// Shortest text that reads back as the same float.
std::string cell(float number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// Writes a CSV row for every tree: its given sizes, the sizes of its shape where none are given, and which
/// sizes were given. Throws CommandError if the file cannot be written.
void writeTrees(const ForestDescription& forest, const std::string& path) {
    AtomicFile whole(path);
    std::ofstream output(toPath(whole.writePath()), std::ios::binary);
    output << "id,species,x,y,z,height,trunk_diameter,crown_width,open,leaves,given\n";
    ForestDescription shapes = forest;
    shapes.trees.clear();
    const PlacedForest placed(std::move(shapes));
    Progress progress("measure", forest.trees.size());
    for (const TreePlacement& tree : forest.trees) {
        output << csvCell(tree.name) << ',' << csvCell(forest.species[tree.species].name);
        for (int axis = 0; axis < 3; ++axis)
            output << ',' << numberText(tree.position[axis]);
        const TreeSize measured = placed.sizeOf(placed.makePlacedTree(tree));
        std::string given;
        const auto write = [&](const char* name, float size, float ofShape, bool estimated) {
            output << ',' << cell(size > 0.0f ? size : ofShape);
            if (size > 0.0f && !estimated)
                given += (given.empty() ? "" : "+") + std::string(name);
        };
        const EstimatedSizes& estimated = tree.estimated;
        write("height", tree.size.height, measured.height, estimated.height);
        write("trunk_diameter", tree.size.trunkDiameter, measured.trunkDiameter, estimated.trunkDiameter);
        write("crown_width", tree.size.crownWidth, measured.crownWidth, estimated.crownWidth);
        output << ',' << tree.openGrown << ',' << cell(tree.leaves) << ',' << (given.empty() ? "none" : given)
               << '\n';
        progress.advance();
    }
    output.close();
    if (!output || !whole.commit())
        throwWriteError(whole);
}

Json toJson(const TreeCounts& counts, std::size_t trees) {
    return {{"trees", trees},
            {"units", counts.units},
            {"branches", counts.branches},
            {"skeletonPoints", counts.skeletonPoints},
            {"skinVertices", counts.skinVertices},
            {"skinTriangles", counts.skinTriangles},
            {"leafVertices", counts.leafVertices},
            {"leafTriangles", counts.leafTriangles},
            {"totalVertices", counts.totalVertices()},
            {"totalTriangles", counts.totalTriangles()}};
}

Json toJson(const ScanReport& scan) {
    return {{"source", scan.source},
            {"cylinders", scan.cylinders},
            {"taken", scan.usedCylinders},
            {"pruned", scan.cylinders - scan.usedCylinders},
            {"units", scan.units},
            {"shoots", scan.shoots},
            {"height", scan.height},
            {"baseDiameter", scan.baseDiameter},
            {"cylinderVolume", scan.cylinderVolume},
            {"woodVolume", scan.woodVolume}};
}

/// Box around the trees at rest, in world coordinates.
Json boundsOf(const ForestDescription& forest) {
    if (forest.trees.empty())
        return nullptr;
    const ShapeFamilies families(forest);
    std::map<std::pair<std::size_t, std::uint32_t>, TreeSize> ofShapes; // by family and shape
    glm::dvec3 low = forest.trees.front().position, high = low;
    for (const TreePlacement& tree : forest.trees) {
        TreeSize size = tree.size;
        if (size.height <= 0.0f || size.crownWidth <= 0.0f) { // missing sizes follow from the shape
            const std::size_t family = families.indexOf(tree);
            const std::uint32_t shape = tree.seed % families.all()[family].shapes;
            const auto [found, isNew] = ofShapes.try_emplace({family, shape});
            if (isNew)
                found->second = measureTree(makeTreeModel(families.all()[family].tree, shape));
            const float height = size.height > 0.0f ? size.height : found->second.height;
            if (size.crownWidth <= 0.0f)
                size.crownWidth = found->second.crownWidth * height / found->second.height;
            size.height = height;
        }
        const double reach = 0.5 * size.crownWidth;
        low = glm::min(low, tree.position - glm::dvec3(reach, reach, 0.0));
        high = glm::max(high, tree.position + glm::dvec3(reach, reach, size.height));
    }
    return {{"low", vectorJson(low)}, {"high", vectorJson(high)}};
}

/// Map projection of the forest, and whether it was chosen from the data.
Json crsOf(const ForestFile& forest) {
    const Result<Crs> crs = Crs::parseMap(forest.crs);
    if (forest.crs.empty() || !crs)
        return nullptr;
    return {{"text", forest.crs}, {"name", crs.value().name()}, {"chosen", forest.crsFromInventory}};
}

Json windOf(const ForestDescription& forest) {
    const glm::vec3 above{0.0f, 0.0f, 10.0f};
    const WindFieldPtr wind = asField(forest.wind);
    const glm::vec3 velocity = wind ? wind->velocity(above, 0.0) : glm::vec3(0.0f);
    return {{"calm", !wind},
            {"velocityAtOrigin10m", vectorJson(velocity)},
            {"intensity", forest.wind.gusts.intensity}};
}

/// Bytes of vertex and index buffers (which grow with the shapes) and of state textures (which grow with the
/// trees).
Json memoryOf(MotionLaw law, const TreeCounts& shapes, const TreeCounts& all) {
    constexpr std::uint64_t unitTexels = 32, leafTexel = 16;
    return {{"shapeBytes", law == MotionLaw::Modal ? meshBytes(shapes) : geometryBytes(shapes)},
            {"textureBytes", all.units * unitTexels + all.leafVertices / verticesPerLeafCluster * leafTexel}};
}

/// Counts over all trees of a species, and over its shapes.
struct SpeciesCounts {
    TreeCounts trees, shapes;
    std::size_t count = 0; ///< Number of trees.
};

/// Counts of all shapes, by family and shape; uses all cores.
std::vector<std::vector<TreeCounts>> countShapes(const ShapeFamilies& families) {
    std::vector<std::vector<TreeCounts>> counts;
    std::vector<std::pair<std::size_t, std::uint32_t>> all;
    for (std::size_t i = 0; i < families.all().size(); ++i) {
        counts.emplace_back(families.all()[i].shapes);
        for (std::uint32_t shape = 0; shape < families.all()[i].shapes; ++shape)
            all.emplace_back(i, shape);
    }
    runJobs(ThreadPool::executor(), all.size(), [&](std::size_t i) {
        const auto& [family, shape] = all[i];
        counts[family][shape] = countTree(families.all()[family].tree, shape);
    });
    return counts;
}

std::vector<SpeciesCounts> countSpecies(const ForestDescription& forest) {
    const ShapeFamilies families(forest);
    std::vector<std::vector<std::size_t>> trees; // number of trees by family and shape
    for (const ShapeFamilies::Family& family : families.all())
        trees.emplace_back(family.shapes, 0);
    for (const TreePlacement& tree : forest.trees) {
        std::vector<std::size_t>& shapes = trees[families.indexOf(tree)];
        ++shapes[tree.seed % shapes.size()];
    }
    const std::vector<std::vector<TreeCounts>> shapes = countShapes(families);
    std::vector<SpeciesCounts> counts(forest.species.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const ShapeFamilies::Family& family = families.all()[i];
        SpeciesCounts& sum = counts[family.species];
        for (std::uint32_t shape = 0; shape < family.shapes; ++shape) {
            const TreeCounts& one = shapes[i][shape];
            for (std::size_t n = 0; n < trees[i][shape]; ++n)
                sum.trees += one;
            sum.shapes += one;
            sum.count += trees[i][shape];
        }
    }
    return counts;
}

Json describe(const ForestFile& forest) {
    Json species = Json::array();
    TreeCounts all, shapes;
    const std::vector<SpeciesCounts> counts = countSpecies(forest);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i].count > 0)
            shapes += counts[i].shapes;
        all += counts[i].trees;
        Json entry = {{"name", forest.species[i].name}, {"shapes", forest.species[i].shapes}};
        entry.update(toJson(counts[i].trees, counts[i].count));
        if (const auto& scans = forest.species[i].tree.scans)
            for (const ScannedTree& scan : *scans)
                entry["scans"].push_back(toJson(scan.report));
        species.push_back(entry);
    }

    Json info = toJson(all, forest.trees.size());
    info["species"] = species;
    info["crs"] = crsOf(forest);
    info["origin"] = vectorJson(forest.origin);
    info["bounds"] = boundsOf(forest);
    info["wind"] = windOf(forest);
    info["motion"] = {{"law", wordOf(forest.law)}, {"gain", forest.gain}, {"noise", "perlin"}};
    if (forest.noiseExponent) {
        info["motion"]["noise"] = "1/f";
        info["motion"]["noiseExponent"] = *forest.noiseExponent;
    }
    info["memory"] = memoryOf(forest.law, shapes, all);
    return info;
}

/// Prints a line for each scanned tree of a species.
void printScans(const Json& species) {
    for (const Json& scan : species["scans"]) {
        const auto number = [&](const char* key) { return scan[key].get<double>(); };
        std::cout << "scan    " << species["name"].get<std::string>() << ": "
                  << scan["source"].get<std::string>() << ", " << scan["cylinders"] << " cylinders, "
                  << scan["pruned"] << " pruned; " << scan["units"] << " units, " << scan["shoots"]
                  << " shoots, " << std::setprecision(3) << number("height") << " m high, "
                  << number("baseDiameter") << " m thick at the ground, " << number("woodVolume") << " of "
                  << number("cylinderVolume") << " m3 of wood" << std::setprecision(6) << '\n';
    }
}

void printTable(const Json& info) {
    const std::vector<std::pair<const char*, const char*>> columns = {{"trees", "trees"},
                                                                      {"units", "units"},
                                                                      {"skinTriangles", "skin triangles"},
                                                                      {"leafTriangles", "leaf triangles"},
                                                                      {"totalVertices", "vertices"},
                                                                      {"totalTriangles", "triangles"}};
    const auto row = [&](const std::string& name, const Json& counts) {
        std::cout << std::left << std::setw(32) << name << std::right;
        for (const auto& column : columns)
            std::cout << std::setw(16) << counts[column.first].get<std::uint64_t>();
        std::cout << '\n';
    };
    std::cout << std::left << std::setw(32) << "species" << std::right;
    for (const auto& column : columns)
        std::cout << std::setw(16) << column.second;
    std::cout << '\n';
    for (const Json& species : info["species"])
        row(species["name"], species);
    row("total", info);
    for (const Json& species : info["species"])
        if (species.contains("scans"))
            printScans(species);
    const Json& crs = info["crs"];
    std::cout << "crs     "
              << (crs.is_null() ? std::string("none: metres")
                                : crs["name"].get<std::string>() + " (" + crs["text"].get<std::string>() +
                                      (crs["chosen"] ? "), chosen by its data" : ")"))
              << '\n';
    std::cout << "origin  " << info["origin"] << "\nbounds  " << info["bounds"] << "\nwind    "
              << info["wind"] << "\nmotion  " << info["motion"] << "\nmemory  " << info["memory"] << '\n';
}

} // namespace

void addInfoCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "info", "Print what a forest contains: trees, species, vertices, extent, wind and memory");
    auto file = std::make_shared<std::string>();
    auto trees = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("file", *file, "Forest or world to read (.treewind file)")->required();
    command->add_flag("--json", *json, "Print the result as JSON");
    command->add_option("--trees", *trees, "CSV file for a list of all trees with their sizes");
    auto tiles = std::make_shared<TileBox>();
    addTilesOption(*command, *tiles);
    command->footer("Example: osgtreewind info forest.treewind --json");
    command->callback([=] {
        const ForestFile forest = loadForest(*file, *tiles);
        const Json info = describe(forest);
        if (*json)
            std::cout << textOf(info) << '\n';
        else
            printTable(info);
        if (!trees->empty())
            writeTrees(forest, *trees);
    });
}
