// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/growth/GrowthFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/HabitCatalogue.h>
#include <osgTreeWind/io/NameMatching.h>
#include <osgTreeWind/io/ReadFields.h>
#include <osgTreeWind/model/TreeFields.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/species/LeafCoverage.h>
#include <osgTreeWind/species/SpeciesFields.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr int usualGrownClusters = 1300, usualGrowthClusters = 3000;
constexpr float usualInclination = 0.6f; // of leaves, where the species does not tell it
constexpr float breastHeight = 1.3f;

void readWoodShape(TableReader& table, RecursiveTreeParameters& tree) {
    readFields(table, tree);
    reportConflicts(table, conflictsOf(tree));
}

/// Radius of a trunk of that length at breast height over that at the ground.
float shareAtBreastHeight(const GrownTreeParameters& tree, float length) {
    return 1.0f - (1.0f - tree.trunkTaper) * breastHeight / length;
}

/// Of the trunk at breast height, in place of its radius at the ground.
void readTrunkDiameter(TableReader& table, GrownTreeParameters& tree) {
    float diameter = 0.0f;
    if (!table.read("trunk_diameter", diameter, within(0.002, 20)))
        return;
    if (table.has("radius"))
        return table.problem("trunk_diameter", "give either this or radius");
    const float length = tree.trunk * tree.height;
    if (!(length > breastHeight))
        return table.problem("trunk_diameter", "expected a trunk, height * trunk, above 1.3 m");
    tree.radius = 0.5f * diameter / shareAtBreastHeight(tree, length);
}

void readGrowth(TableReader& table, GrownTreeParameters& tree) {
    readFields(table, tree);
    readTrunkDiameter(table, tree);
    reportConflicts(table, conflictsOf(tree));
}

void readLeafShape(TableReader& table, LeafParameters& leaves) {
    readFields(table, leaves);
    if (table.has("clusters_per_branch") && !table.has("clusters"))
        leaves.clusters = 0;
}

/// Adds the trees of a file that `scan` names. False after a problem.
bool addScans(TableReader& table, ForestReading& reading, const std::string& name,
              std::vector<ScannedTree>& scans) {
    const auto found = reading.open(table, "scan", name);
    if (!found)
        return false;
    const Result<ScanFile> file = readScanFile(found->path);
    if (!file) {
        table.problem("scan", file.problems().front().text());
        return false;
    }
    const std::vector<ScanCylinders>& trees = file.value().trees;
    if (scans.size() + trees.size() > mostShapes) {
        table.problem("scan", "expected at most 64 trees in all files, found more in " + found->path);
        return false;
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        scans.push_back(makeScannedTree(trees[i]).value());
        ScanReport& report = scans.back().report;
        report.file = found->path;
        report.tree = i;
        report.trees = trees.size();
        report.source = std::filesystem::path(found->path).filename().string();
        if (trees.size() > 1)
            report.source += ", tree " + std::to_string(i + 1);
    }
    return true;
}

/// Of a tree as it was said to be before it grew by light: at breast height.
float trunkDiameter(const GrownTreeParameters& tree) {
    return 2.0f * tree.radius * shareAtBreastHeight(tree, std::max(tree.trunk * tree.height, breastHeight));
}

/// `habit`: the species grows by light.
void readHabit(TableReader& table, Species& species) {
    TreeParameters& tree = species.tree;
    if (!tree.growth) {
        tree.growth.emplace();
        if (tree.grown) {
            tree.growth->size = {tree.grown->height, trunkDiameter(*tree.grown), tree.grown->crownWidth};
            tree.growth->flare = tree.grown->flare;
        }
        tree.leaves.clusters = usualGrowthClusters;
        if (!(tree.leaves.inclination > 0.0f))
            tree.leaves.inclination = usualInclination;
    }
    if (std::string like; table.read("like", like)) {
        const auto habit = builtInHabits().find(foldedName(like));
        if (habit != builtInHabits().end())
            tree.growth->habit = habit->second;
        else
            table.problem("like", "no built-in habit " + inQuotes(like));
    }
    readFields(table, *tree.growth);
    tree.grown.reset();
}

/// A scan knows of no leaves: those of the species, so many as on a built-in tree, on the thinner wood.
void spreadOnScans(LeafParameters& leaves) {
    leaves.firstLevel = 0;
    leaves.clusters = usualGrownClusters;
    leaves.bare = 0.0f;
    leaves.thinWood = 0.6f;
    if (!(leaves.inclination > 0.0f))
        leaves.inclination = usualInclination;
}

/// `scan`: a file of measured trees, or several. They are the shapes.
void readScans(TableReader& table, ForestReading& reading, Species& species) {
    std::vector<std::string> names(1);
    const bool given = table.hasArray("scan") ? table.read("scan", names) : table.read("scan", names.front());
    if (!given)
        return;
    for (const char* key : {"tree", "growth", "habit", "shapes"})
        if (table.has(key))
            return table.problem(key, "expected none beside scan, whose trees are the shapes");
    std::vector<ScannedTree> scans;
    for (const std::string& name : names)
        if (!addScans(table, reading, name, scans))
            return;
    if (scans.empty())
        return table.problem("scan", "expected at least one file");
    species.shapes = static_cast<int>(scans.size());
    spreadOnScans(species.tree.leaves);
    species.tree.grown.reset();
    species.tree.growth.reset();
    species.tree.scans = std::make_shared<const std::vector<ScannedTree>>(std::move(scans));
}

/// A note where a species is called as a built-in one, says nothing of its shape and is not like it.
void noteUnlike(TableReader& table, ForestReading& reading, const std::string& name) {
    for (const char* key : {"like", "tree", "growth", "habit", "scan"})
        if (table.has(key))
            return;
    if (const Species* known = reading.builtIn().find(name))
        reading.forest.notes.push_back("the species " + inQuotes(name) +
                                       " has the shape of the thesis' tree; like = " + inQuotes(known->name) +
                                       " gives it that of the built-in one");
}

void addName(TableReader& table, ForestReading& reading, const std::string& key, const std::string& name) {
    if (!reading.speciesByName.emplace(foldedName(name), reading.forest.species.size()).second)
        table.problem(key, "the name " + inQuotes(name) + " is taken already");
}

} // namespace

void readSpecies(TableReader& table, ForestReading& reading) {
    Species species;
    std::string like;
    if (table.read("like", like)) {
        if (const Species* model = reading.builtIn().findModel(like))
            species = *model;
        else
            table.problem("like", "no built-in species " + inQuotes(like));
    }
    if (table.require("name", species.name)) {
        addName(table, reading, "name", species.name);
        noteUnlike(table, reading, species.name);
    }
    species.aliases.clear();
    readScans(table, reading, species);
    table.table("tree", [&](TableReader& t) {
        species.tree.grown.reset();
        species.tree.growth.reset();
        readWoodShape(t, species.tree.wood);
    });
    table.table("growth", [&](TableReader& t) {
        species.tree.growth.reset();
        if (!species.tree.grown)
            species.tree.leaves.clusters = usualGrownClusters;
        readGrowth(t, species.tree.grown ? *species.tree.grown : species.tree.grown.emplace());
    });
    table.table("habit", [&](TableReader& t) {
        if (table.has("tree") || table.has("growth"))
            return table.problem("habit", "give either this or tree or growth");
        readHabit(t, species);
    });
    bool sized = false;
    table.table("leaves", [&](TableReader& t) {
        species.tree.leaves.area = 0.0f;
        readLeafShape(t, species.tree.leaves);
        sized = t.has("area") || t.has("length") || t.has("width");
    });
    readFields(table, species, [&](TableReader& t, const std::string& key, std::string& name) {
        const auto file = reading.open(t, key, name);
        name = file ? file->path : "";
    });
    for (const std::string& alias : species.aliases)
        addName(table, reading, "aliases", alias);
    if (!sized)
        species.tree.leaves.area =
            species.tree.growth || species.tree.grown || species.tree.scans ? cardArea(species) : 0.0f;
    reading.forest.species.push_back(std::move(species));
}

} // namespace osgTreeWind
