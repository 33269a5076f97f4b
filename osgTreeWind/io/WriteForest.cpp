// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/base/WholeFile.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/growth/GrowthFields.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/io/TreesInAll.h>
#include <osgTreeWind/model/TreeFields.h>
#include <osgTreeWind/places/MapScale.h>
#include <osgTreeWind/species/SpeciesFields.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace osgTreeWind {

namespace {

/// What could be, but not be written.
class Refusals {
public:
    explicit Refusals(const ForestDescription& forest) : _problems(check(forest)) {
        if (!isUtf8(forest.crs))
            add("crs", "expected UTF-8");
        if (!isUtf8(forest.hostCrs))
            add("host_crs", "expected UTF-8");
        if (forest.species.empty())
            add("species", "expected at least one");
        for (std::size_t i = 0; i < forest.species.size(); ++i)
            ofSpecies(forest.species[i], "species[" + std::to_string(i) + ']');
        std::set<std::string> names;
        for (std::size_t i = 0; i < forest.trees.size(); ++i)
            if (const std::string& name = forest.trees[i].name; !name.empty())
                ofName(name, names, "tree[" + std::to_string(i) + "].id", name);
        if (!_problems.empty())
            return;
        if (const std::string problem = problemOfShapes(forest); !problem.empty())
            add("species", problem);
    }

    Diagnostics take() { return std::move(_problems); }

private:
    void add(const std::string& key, const std::string& message) {
        _problems.push_back(keyProblem(key, message));
    }
    void ofName(const std::string& name, std::set<std::string>& names, const std::string& key,
                const std::string& folded) {
        if (!isUtf8(name))
            add(key, "expected UTF-8");
        else if (!names.insert(folded).second)
            add(key, "the name " + inQuotes(name) + " is taken already");
    }
    void ofSpecies(const Species& species, const std::string& path) {
        if (species.name.empty())
            add(path + ".name", "missing");
        ofName(species.name, _species, path + ".name", foldedName(species.name));
        for (const std::string& alias : species.aliases)
            ofName(alias, _species, path + ".aliases", foldedName(alias));
        if (!isUtf8(species.source))
            add(path + ".source", "expected UTF-8");
        if (!isUtf8(species.height.source))
            add(path + ".height.source", "expected UTF-8");
        for (const std::string* picture : {&species.appearance.leafImage, &species.appearance.barkImage})
            if (!picture->empty())
                ofFile(*picture, path + ".appearance");
        if (species.tree.scans)
            ofScans(species, path + ".scan");
    }
    void ofFile(const std::string& file, const std::string& key) {
        if (const std::string problem = problemOfFile(file); !problem.empty())
            add(key, problem);
    }
    /// All trees of each file have to be there, and be all there is.
    void ofScans(const Species& species, const std::string& key) {
        const std::vector<ScannedTree>& scans = *species.tree.scans;
        for (std::size_t i = 0; i < scans.size(); ++i) {
            const ScanReport& scan = scans[i].report;
            if (scan.file.empty())
                return add(key, "scan " + std::to_string(i) + " was not read from a file");
            const bool follows = scan.tree == 0 || (i > 0 && scans[i - 1].report.file == scan.file &&
                                                    scans[i - 1].report.tree + 1 == scan.tree);
            const bool ends =
                scan.tree + 1 == scan.trees || (i + 1 < scans.size() && scans[i + 1].report.tree > 0);
            if (!follows || !ends)
                return add(key, "expected all trees of " + inQuotes(scan.file) + ", in their order");
            ofFile(scan.file, key);
        }
        if (species.shapes != static_cast<int>(scans.size()) || species.tree.palm || species.tree.growth)
            add(key, "expected as many shapes as scans, and no palm or habit beside them");
        const RecursiveTreeParameters usual;
        for (const Field& field : fieldsOf<RecursiveTreeParameters>())
            if (!sameField(field, &species.tree.wood, &usual))
                return add(key, "expected no tree beside scans");
    }

    std::set<std::string> _species;
    Diagnostics _problems;
};

void writeScans(std::ostream& output, const std::vector<ScannedTree>& scans) {
    std::vector<std::string> files;
    for (const ScannedTree& scan : scans)
        if (scan.report.tree == 0)
            files.push_back(std::filesystem::absolute(scan.report.file).string());
    output << "scan = " << tomlText(files) << '\n';
}

void writeSpecies(std::ostream& output, const Species& species) {
    output << "\n[[species]]\nname = " << tomlText(species.name) << '\n';
    Species usual;
    if (species.tree.scans) {
        writeScans(output, *species.tree.scans);
        usual.shapes = species.shapes;
    }
    writeFields(output, "species", species, usual);
    writeTable(output, "species.tree", species.tree.wood);
    if (species.tree.palm) {
        output << "\n[species.palm]\n";
        writeFields(output, "species.palm", *species.tree.palm);
    }
    if (species.tree.growth) {
        output << "\n[species.habit]\n";
        writeFields(output, "species.habit", *species.tree.growth);
    }
    output << "\n[species.leaves]\n"; // all: what is not said depends on the rest
    writeFields(output, "species.leaves", fieldsOf<LeafParameters>(), &species.tree.leaves, nullptr);
}

void writeTree(std::ostream& output, const TreePlacement& tree, const ForestDescription& forest) {
    output << "\n[[tree]]\nspecies = " << tomlText(forest.species[tree.species].name)
           << "\nposition = " << tomlText(tree.position) << '\n';
    TreePlacement usual;
    usual.seed = ~tree.seed;           // it is always written: else its place in the file would tell it
    usual.openGrown = !tree.openGrown; // likewise: else what stands around it would
    for (float TreeSize::*size : {&TreeSize::height, &TreeSize::trunkDiameter, &TreeSize::crownWidth})
        if (!(tree.size.*size > 0.0f))
            usual.size.*size = tree.size.*size; // not given
    writeFields(output, "tree", tree, usual);
}

void writeMotion(std::ostream& output, const ForestDescription& forest) {
    output << "\n[motion]\n";
    writeFields(output, "motion", forest);
    if (forest.noiseExponent)
        output << "noise = \"1/f\"\nnoise_exponent = " << tomlText(*forest.noiseExponent) << '\n';
}

/// Whether a reader would leave the map of a forest made in code for one in true metres.
bool isOnStretchedMap(const ForestDescription& forest) {
    if (forest.crs.empty() || forest.trees.empty())
        return false;
    const Result<Crs> map = Crs::parse(forest.crs);
    if (!map)
        return false;
    TreesInAll trees;
    trees.add(forest.trees);
    return scaleOfMap(map.value(), 0.5 * glm::dvec2(trees.low + trees.high)) != 1.0;
}

/// Names a folder of tiles below its own by the way there, so that both may move.
ForestDescription besideItsTiles(ForestDescription forest, const std::string& file) {
    namespace fs = std::filesystem;
    const fs::path way = fs::path(forest.tiles->folder)
                             .lexically_relative(fs::absolute(file).lexically_normal().parent_path());
    if (!way.empty() && *way.begin() != "..")
        forest.tiles->folder = way.string();
    return forest;
}

} // namespace

Diagnostics writeForest(const ForestDescription& forest, std::ostream& output) {
    Diagnostics problems = Refusals(forest).take();
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
    const ForestDescription usual;
    writeFields(output, "", fieldsOfFile(), &forest, &usual);
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
        forest.tiles ? writeForest(besideItsTiles(forest, path), text) : writeForest(forest, text);
    if (problems.empty())
        return writeWholeFile(path, text.str());
    for (Diagnostic& problem : problems)
        problem.file = path;
    return problems;
}

} // namespace osgTreeWind
