// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/io/TreeBounds.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/places/MapScale.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/system/Path.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Finds problems that keep a forest from being written.
class WriteChecks {
public:
    explicit WriteChecks(const ForestDescription& forest) : _problems(check(forest)) {
        if (forest.species.empty())
            add("species", "expected at least one");
        for (std::size_t i = 0; i < forest.species.size(); ++i)
            checkSpecies(forest.species[i], "species[" + std::to_string(i) + ']');
        std::set<std::string> names;
        for (std::size_t i = 0; i < forest.trees.size(); ++i)
            if (const std::string& name = forest.trees[i].name; !name.empty())
                checkName(name, names, "tree[" + std::to_string(i) + "].id", name);
        if (!_problems.empty())
            return;
        const ShapeFamilies families(forest);
        if (const std::string problem = problemOfShapes(families, families.countLargest()); !problem.empty())
            add("species", problem);
    }

    Diagnostics take() { return std::move(_problems); }

private:
    void add(const std::string& key, const std::string& message) {
        _problems.push_back(keyProblem(key, message));
    }
    void checkName(const std::string& name, std::set<std::string>& names, const std::string& key,
                   const std::string& folded) {
        if (!names.insert(folded).second)
            add(key, "the name " + inQuotes(name) + " is taken already");
    }
    void checkSpecies(const Species& species, const std::string& path) {
        if (species.name.empty())
            add(path + ".name", "missing");
        checkName(species.name, _species, path + ".name", foldedName(species.name));
        for (const std::string& alias : species.aliases)
            checkName(alias, _species, path + ".aliases", foldedName(alias));
        for (const std::string* picture : {&species.appearance.leafImage, &species.appearance.barkImage})
            if (!picture->empty())
                checkFile(*picture, path + ".appearance");
        if (species.tree.scans)
            checkScans(species, path + ".scan");
    }
    void checkFile(const std::string& file, const std::string& key) {
        if (const std::string problem = problemOfFile(file); !problem.empty())
            add(key, problem);
    }
    /// The shapes must be exactly the trees of each file, in order.
    void checkScans(const Species& species, const std::string& key) {
        const std::vector<ScannedTree>& scans = *species.tree.scans;
        for (std::size_t i = 0; i < scans.size(); ++i) {
            const ScanReport& scan = scans[i].report;
            if (scan.file.empty())
                return add(key, "scan " + std::to_string(i) + " was not read from a file");
            const bool isNext = scan.tree == 0 || (i > 0 && scans[i - 1].report.file == scan.file &&
                                                   scans[i - 1].report.tree + 1 == scan.tree);
            const bool isComplete =
                scan.tree + 1 == scan.trees || (i + 1 < scans.size() && scans[i + 1].report.tree > 0);
            if (!isNext || !isComplete)
                return add(key, "expected all trees of " + inQuotes(scan.file) + ", in their order");
            checkFile(scan.file, key);
        }
        if (species.shapes != static_cast<int>(scans.size()) || species.tree.palm || species.tree.growth)
            add(key, "expected as many shapes as scans, and neither a palm nor a habit");
        const RecursiveTreeParameters defaults;
        for (const Key& each : keysOf<RecursiveTreeParameters>())
            if (!isKeyEqual(each, &species.tree.wood, &defaults))
                return add(key, "cannot be combined with scans");
    }

    std::set<std::string> _species;
    Diagnostics _problems;
};

void writeScans(std::ostream& output, const std::vector<ScannedTree>& scans) {
    std::vector<std::string> files;
    for (const ScannedTree& scan : scans)
        if (scan.report.tree == 0)
            files.push_back(absolutePath(scan.report.file));
    output << "scan = " << tomlText(files) << '\n';
    if (const std::string& up = scans.front().report.up; !up.empty())
        output << "up = " << tomlText(up) << '\n';
}

void writeSpecies(std::ostream& output, const Species& species) {
    output << "\n[[species]]\nname = " << tomlText(species.name) << '\n';
    Species defaults;
    if (species.tree.scans) {
        writeScans(output, *species.tree.scans);
        defaults.shapes = species.shapes;
    }
    writeKeys(output, "species", species, defaults);
    writeTable(output, "species.tree", species.tree.wood);
    if (species.tree.palm) {
        output << "\n[species.palm]\n";
        writeKeys(output, "species.palm", *species.tree.palm);
    }
    if (species.tree.growth) {
        output << "\n[species.habit]\n";
        writeKeys(output, "species.habit", *species.tree.growth);
    }
    output << "\n[species.leaves]\n"; // all keys, because defaults depend on other tables
    writeKeys(output, "species.leaves", keysOf<LeafParameters>(), &species.tree.leaves, nullptr);
}

void writeTree(std::ostream& output, const TreePlacement& tree, const ForestDescription& forest) {
    output << "\n[[tree]]\nspecies = " << tomlText(forest.species[tree.species].name)
           << "\nposition = " << tomlText(tree.position) << '\n';
    TreePlacement defaults;
    defaults.seed = ~tree.seed;           // always written, because a reader would derive it from the index
    defaults.openGrown = !tree.openGrown; // always written, because a reader would derive it from neighbours
    for (float TreeSize::*size : {&TreeSize::height, &TreeSize::trunkDiameter, &TreeSize::crownWidth})
        if (!(tree.size.*size > 0.0f))
            defaults.size.*size = tree.size.*size; // not given
    writeKeys(output, "tree", tree, defaults);
}

void writeMotion(std::ostream& output, const ForestDescription& forest) {
    output << "\n[motion]\n";
    writeKeys(output, "motion", forest);
    if (forest.noiseExponent)
        output << "noise = \"1/f\"\nnoise_exponent = " << tomlText(*forest.noiseExponent) << '\n';
}

/// Whether a reader would reproject the forest unless the file has `stretched = true`.
bool isOnStretchedMap(const ForestDescription& forest) {
    if (forest.crs.empty() || forest.trees.empty())
        return false;
    const Result<Crs> map = Crs::parse(forest.crs);
    if (!map)
        return false;
    TreeBounds trees;
    trees.add(forest.trees);
    return scaleOfMap(map.value(), 0.5 * glm::dvec2(trees.low + trees.high)) != 1.0;
}

/// Makes the path of the tiles relative if they are below the file's folder, so that both can be moved.
ForestDescription withRelativeTileFolder(ForestDescription forest, const std::string& file) {
    namespace fs = std::filesystem;
    const fs::path relative =
        toPath(forest.tiles->folder)
            .lexically_relative(toPath(absolutePath(file)).lexically_normal().parent_path());
    if (!relative.empty() && *relative.begin() != "..")
        forest.tiles->folder = toText(relative);
    return forest;
}

} // namespace

std::string problemOfFile(const std::string& file) {
    std::error_code error;
    return isUtf8(file) && std::filesystem::is_regular_file(toPath(file), error)
               ? ""
               : "no file " + inQuotes(file);
}

Diagnostics writeForest(const ForestDescription& forest, std::ostream& output) {
    Diagnostics problems = WriteChecks(forest).take();
    std::ostringstream wind;
    if (const std::string problem = writeWind(wind, forest); !problem.empty())
        problems.push_back(keyProblem("wind", problem));
    std::ostringstream ground;
    if (const std::string problem = writeGround(ground, forest); !problem.empty())
        problems.push_back(keyProblem("ground", problem));
    if (!problems.empty())
        return problems;
    output << "version = 1\nseason = " << tomlText(forest.season) << "\norigin = " << tomlText(forest.origin)
           << '\n';
    const ForestDescription defaults;
    writeKeys(output, "", forestFileKeys(), &forest, &defaults);
    if (isOnStretchedMap(forest))
        output << "stretched = true\n";
    if (forest.trees.empty() && !forest.tiles)
        output << "tree = []\n";
    output << ground.str() << wind.str();
    writeMotion(output, forest);
    writeTable(output, "drawing", forest.drawing);
    for (const Species& species : forest.species)
        writeSpecies(output, species);
    for (const TreePlacement& tree : forest.trees)
        writeTree(output, tree, forest);
    if (forest.tiles)
        writeTiles(output, *forest.tiles);
    output.flush();
    if (!output)
        return {keyProblem({}, "cannot be written")};
    return {};
}

Diagnostics writeForestFile(const ForestDescription& forest, const std::string& path) {
    std::ostringstream text;
    Diagnostics problems =
        forest.tiles ? writeForest(withRelativeTileFolder(forest, path), text) : writeForest(forest, text);
    if (problems.empty())
        return writeFileAtomically(path, text.str());
    for (Diagnostic& problem : problems)
        problem.file = path;
    return problems;
}

} // namespace osgTreeWind
