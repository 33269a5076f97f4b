// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/ReadFields.h>
#include <osgTreeWind/io/StretchedMap.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/places/HostMap.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace osgTreeWind {

std::optional<std::size_t> ForestReading::species(const std::string& name) const {
    const auto found = speciesByName.find(foldedName(name));
    if (found == speciesByName.end())
        return std::nullopt;
    return found->second;
}

std::optional<std::size_t> ForestReading::speciesOrBuiltIn(const std::string& name) {
    if (const auto declared = species(name))
        return declared;
    return addBuiltIn(builtIn().find(name));
}

std::optional<std::size_t> ForestReading::addBuiltIn(const Species* found) {
    if (!found)
        return std::nullopt;
    // The document's "oak" has precedence over a built-in "oak" that was found as "English oak".
    const auto [entry, isNew] = speciesByName.emplace(foldedName(found->name), forest.species.size());
    if (isNew) {
        std::vector<std::string>& aliases = forest.species.emplace_back(*found).aliases;
        const auto isUsed = [&](const std::string& alias) {
            return speciesByName.count(foldedName(alias)) > 0;
        };
        aliases.erase(std::remove_if(aliases.begin(), aliases.end(), isUsed), aliases.end());
    }
    return entry->second;
}

const SpeciesCatalogue& ForestReading::builtIn() {
    if (!catalogue) {
        const Result<SpeciesCatalogue>& host = SpeciesCatalogue::hostCatalogue();
        if (!host.ok())
            for (const Diagnostic& problem : host.problems())
                log.add(problem);
        catalogue = host.ok() ? &host.value() : &SpeciesCatalogue::builtIn();
    }
    return *catalogue;
}

TreeBounds ForestReading::treeBounds() {
    TreeBounds all;
    trees.visit([&](const TreeSpool::Trees& some) { all.add(some); });
    return all;
}

void ForestReading::addTree(const TreePlacement& tree, bool onGround, DerivedTreeValues derivedValues) {
    trees.add(tree, onGround);
    if (trees.isInMemory())
        derived.push_back(derivedValues);
}

void ForestReading::setCrs(const Crs& newCrs) {
    crs = newCrs;
    forest.crs = newCrs.text();
    forest.crsFromInventory = true;
}

glm::dvec3 ForestReading::scenePlace(const glm::dvec3& place) const {
    glm::dvec2 transformed(place);
    toScene.apply(transformed);
    return {transformed, place.z};
}

bool ForestReading::canAddTrees(std::uint64_t count, TableReader& table, const std::string& key) {
    if (count <= maxTrees && trees.size() + count <= maxTrees)
        return true;
    table.problem(key, "more than " + std::to_string(maxTrees) + " trees in all");
    return false;
}

std::vector<std::string> hostFolders() {
#ifdef _WIN32
    constexpr char separator = ';';
#else
    constexpr char separator = ':';
#endif
    const char* const text = std::getenv("OSG_FILE_PATH");
    std::istringstream rest(text ? text : "");
    std::vector<std::string> folders;
    for (std::string folder; std::getline(rest, folder, separator);)
        if (!folder.empty())
            folders.push_back(folder);
    return folders;
}

std::vector<std::string> ForestReading::trustedFolders() const {
    std::vector<std::string> trusted = hostFolders();
    trusted.push_back(folders.front());
    if (const char* data = std::getenv("OSGTREEWIND_DATA"))
        trusted.emplace_back(data);
    return trusted;
}

std::optional<ForestReading::InputFile> ForestReading::open(TableReader& table, const std::string& key) {
    std::string name;
    if (!table.require(key, name))
        return std::nullopt;
    return open(table, key, name);
}

std::optional<ForestReading::InputFile> ForestReading::open(TableReader& table, const std::string& key,
                                                            const std::string& name) {
    std::error_code error;
    for (const std::string& folder : folders) {
        const std::filesystem::path path = std::filesystem::path(folder) / name; // `name` may be absolute
        if (!std::filesystem::is_regular_file(path, error))
            continue;
        if (const std::string problem = problemOfTrust(path.string(), trustedFolders()); !problem.empty()) {
            table.problem(key, inQuotes(name) + ' ' + problem);
            return std::nullopt;
        }
        Result<std::ifstream> stream = openInput(path.string());
        if (stream)
            return InputFile{path.string(), std::move(stream.value())};
        table.problem(key, inQuotes(path.string()) + " " + stream.problems().front().message);
        return std::nullopt;
    }
    table.problem(key, "no file " + inQuotes(name) + " in " + joined(folders));
    return std::nullopt;
}

std::string problemOfShapes(const ForestDescription& forest) {
    constexpr std::uint64_t maxVertices = 50000000;
    std::uint64_t vertices = 0;
    const ShapeFamilies families(forest);
    const std::vector<TreeCounts> largest = families.countLargest();
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

void readHead(TableReader& root, ForestReading& reading) {
    readVersion(root);
    root.read("seed", reading.seed);

    std::vector<std::string> search;
    root.read("search", search);
    for (const std::string& folder : search)
        reading.folders.push_back((std::filesystem::path(reading.forest.folder) / folder).lexically_normal());
    if (const char* data = std::getenv("OSGTREEWIND_DATA"))
        reading.folders.emplace_back(data);
}

void readCrs(TableReader& root, ForestReading& reading) {
    readFields(root, forestFileFields(), &reading.forest);
    root.read("stretched", reading.keepsStretchedMap);
    if (reading.forest.crs.empty())
        return;
    auto crs = Crs::parseMap(reading.forest.crs);
    if (crs)
        reading.crs = std::move(crs.value());
    else
        root.problem("crs", crs.problems().front().message);
}

void readSeason(TableReader& root, ForestReading& reading) {
    std::string text;
    if (!root.readScalar("season", text))
        return;
    if (const std::optional<float> season = parseSeason(text))
        reading.forest.season = *season;
    else
        root.problem("season", expectedFound(seasonSyntax, text));
}

void readMotion(TableReader& table, ForestReading& reading) {
    Fields fields = fieldsOf<ForestDescription>();
    if (table.hasText("law", "damped")) { // a law of version 1.0
        reading.forest.notes.emplace_back("motion.law: \"damped\" no longer exists; it is read as \"modal\"");
        fields.front().words.emplace_back("damped", static_cast<int>(MotionLaw::Modal));
    }
    readFields(table, fields, &reading.forest);
    table.read("leaves", reading.leaves, fieldAt(fieldsOf<TreePlacement>(), "leaves").range);
    bool isFractal = false;
    const bool isKnown = table.readChoice<bool>("noise", isFractal, {{"perlin", false}, {"1/f", true}});
    float exponent = 1.0f;
    const bool isExponentGiven = table.read("noise_exponent", exponent, noiseExponents);
    if (isFractal)
        reading.forest.noiseExponent = exponent;
    else if (isExponentGiven && (isKnown || !table.has("noise")))
        table.problem("noise_exponent", "expected noise = \"1/f\" with it");
}

/// Adds a species with default values to a file without species.
void ensureSpecies(TableReader& root, ForestReading& reading) {
    if (root.has("species"))
        return;
    Species species;
    species.name = "tree";
    reading.forest.species = {species};
    reading.speciesByName["tree"] = 0;
}

/// Removes the species added by ensureSpecies() if all trees are of built-in species.
void removeUnusedDefault(ForestReading& reading) {
    std::vector<Species>& species = reading.forest.species;
    bool isUsed = species.size() == 1;
    reading.trees.visit([&](const TreeSpool::Trees& trees) {
        isUsed = isUsed || std::any_of(trees.begin(), trees.end(),
                                       [](const TreePlacement& tree) { return tree.species == 0; });
    });
    if (isUsed)
        return;
    species.erase(species.begin());
    reading.trees.modify([](TreeSpool::Trees& trees, const std::vector<std::size_t>&) {
        for (TreePlacement& tree : trees)
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

void readOrigin(TableReader& root, ForestReading& reading) {
    ForestDescription& forest = reading.forest;
    std::vector<double> origin;
    if (root.readNumbers("origin", origin, 3, 3, worldCoordinates))
        forest.origin = reading.scenePlace({origin[0], origin[1], origin[2]});
    else if (forest.tiles)
        root.problem("origin", "missing: [tiles] needs it");
    else
        forest.origin = defaultOrigin(reading.treeBounds());
    const auto isFar = [&](const TreePlacement& tree) {
        return glm::distance(tree.position, forest.origin) > maxTreeDistance;
    };
    std::optional<glm::dvec3> first;
    reading.trees.visit([&](const TreeSpool::Trees& trees) {
        const auto far = first ? trees.end() : std::find_if(trees.begin(), trees.end(), isFar);
        if (far != trees.end())
            first = far->position;
    });
    if (first && reading.log.problems.empty()) // otherwise an inventory may have reported the row
        root.problem("origin", "a tree at (" + numberText(first->x) + ", " + numberText(first->y) + ", " +
                                   numberText(first->z) + ") is more than 100 km from the origin");
}

} // namespace

void readRoot(TableReader& root, ForestReading& reading) {
    readHead(root, reading);
    readCrs(root, reading);
    readSeason(root, reading);
    root.table("motion", [&](TableReader& table) { readMotion(table, reading); });
    root.table("drawing", [&](TableReader& table) {
        readFields(table, reading.forest.drawing);
        reportConflicts(table, conflictsOf(reading.forest.drawing));
    });
    ensureSpecies(root, reading);
    root.tables("species", [&](TableReader& table) { readSpecies(table, reading); });
    if (reading.forest.species.empty())
        root.problem("species", "expected at least one [[species]]");
    reading.hasSpeciesTables = root.has("species");
    reading.declaredSpecies = reading.forest.species.size();

    root.tables("tree", [&](TableReader& table) { readTree(table, reading); });
    root.tables("scatter", [&](TableReader& table) { readScatter(table, reading); });
    root.tables("inventory", [&](TableReader& table) { readInventory(table, reading); });
    root.table("tiles", [&](TableReader& table) { readTiles(table, reading); });
    if (!root.has("tree") && !root.has("scatter") && !root.has("inventory") && !root.has("tiles"))
        root.problem("", "no trees: expected [[tree]], [scatter], [inventory] or [tiles]");
    if (reading.forest.tiles && reading.forest.law != MotionLaw::Modal)
        root.problem("tiles", "expected the law \"modal\" with tiles");

    if (!root.has("species"))
        removeUnusedDefault(reading);
    reprojectStretchedMap(reading);

    if (reading.log.problems.empty() && reading.trees.isInMemory()) {
        findGrowingSpaces(reading.forest, reading.derived);
        varyNeighbourSeeds(reading.forest, reading.derived);
    }
    if (reading.log.problems.empty())
        if (const std::string problem = problemOfShapes(reading.forest); !problem.empty())
            root.problem("species", problem);
    root.table("ground", [&](TableReader& table) { readGround(table, reading); });
    if (reading.log.problems.empty())
        if (const std::string problem = problemOfMemory(reading.forest, false); !problem.empty())
            root.problem("", problem);
    readOrigin(root, reading);
    if (!reading.forest.hostCrs.empty())
        if (const auto place =
                hostMapTransform(reading.forest.crs, reading.forest.origin, reading.forest.hostCrs);
            !place)
            root.problem("host_crs", place.problems().front().message);
    root.table("wind", [&](TableReader& table) { readWind(table, reading); });
}

} // namespace osgTreeWind
