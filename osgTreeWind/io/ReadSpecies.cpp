// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/LegacyGrowth.h>
#include <osgTreeWind/io/ReadKeys.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/species/LeafCoverage.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/system/Path.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr int scanClusters = 1300, palmClusters = 240, habitClusters = 3000;
constexpr float defaultInclination = 0.6f; // of leaves, radians

void readWoodShape(TableReader& table, RecursiveTreeParameters& tree) {
    readKeys(table, tree);
    reportConflicts(table, conflictsOf(tree));
}

void readLeafShape(TableReader& table, LeafParameters& leaves) {
    readKeys(table, leaves);
    if (table.has("clusters_per_branch") && !table.has("clusters"))
        leaves.clusters = 0;
}

/// Adds the trees of a file named by `scan`. @return false after a problem.
bool addScans(TableReader& table, const InputFolders& folders, const std::string& name, ScanUp up,
              std::vector<ScannedTree>& scans) {
    const auto found = folders.open(table, "scan", name);
    if (!found)
        return false;
    const Result<ScanFile> file = readScanFile(found->path, up);
    if (!file) {
        table.problem("scan", file.problems().front().text());
        return false;
    }
    const std::vector<ScanCylinders>& trees = file.value().trees;
    for (const std::string& note : file.value().notes)
        table.note(found->path + ": " + note);
    if (scans.size() + trees.size() > maxShapes) {
        table.problem("scan", "expected at most 64 trees in all files, found more in " + found->path);
        return false;
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        scans.push_back(makeScannedTree(trees[i]).value());
        if (const std::size_t joined = file.value().joined[i]; joined > 0)
            table.note(found->path + ": " + std::to_string(joined) +
                       " branches without a parent are joined to the nearest cylinder");
        ScanReport& report = scans.back().report;
        report.file = found->path;
        report.up = up == ScanUp::Found ? "" : up == ScanUp::Y ? "y" : "z";
        report.tree = i;
        report.trees = trees.size();
        report.source = toText(toPath(found->path).filename());
        if (trees.size() > 1)
            report.source += ", tree " + std::to_string(i + 1);
    }
    return true;
}

void useLeaves(LeafParameters& leaves, int clusters) {
    leaves.clusters = clusters;
    if (!(leaves.inclination > 0.0f))
        leaves.inclination = defaultInclination;
}

/// The species or group that a key `like` names, with a note if it is a generic species; null if there is
/// none.
const Species* findTemplate(TableReader& table, const std::string& like, DocumentSpecies& known) {
    const Species* found = known.builtIn().findTemplate(like);
    if (const std::string note = found ? genericSpeciesNote(like, *found) : ""; !note.empty())
        table.note("like: " + note);
    return found;
}

/// Reads [species.habit] of a species that grows by light.
void readHabit(TableReader& table, DocumentSpecies& known, TreeParameters& tree) {
    if (!tree.growth) {
        tree.growth.emplace();
        useLeaves(tree.leaves, habitClusters);
    }
    if (std::string like; table.read("like", like)) {
        const Species* model = findTemplate(table, like, known);
        if (model && model->tree.growth)
            tree.growth->habit = model->tree.growth->habit;
        else
            table.problem("like", "no built-in species with a habit is called " + inQuotes(like));
    }
    readKeys(table, *tree.growth);
    tree.palm.reset();
}

void readPalm(TableReader& table, TreeParameters& tree) {
    if (!tree.palm) {
        tree.palm.emplace();
        tree.leaves.clusters = palmClusters;
        tree.leaves.frond = true;
    }
    readKeys(table, *tree.palm);
    reportConflicts(table, conflictsOf(*tree.palm));
    tree.growth.reset();
}

/// Whether the leaves are fronds, by the key `leaves.frond` or else by the species that this one is like.
bool isPalm(TableReader& table, const TreeParameters& tree) {
    bool frond = tree.palm.has_value();
    table.table("leaves", [&](TableReader& leaves) {
        leaves.read("frond", frond);
        leaves.ignoreRest();
    });
    return frond;
}

/// Distributes leaves on the thinner wood of scans, as many as on a built-in tree.
void useLeavesOnScans(LeafParameters& leaves) {
    leaves.firstLevel = 0;
    leaves.bare = 0.0f;
    leaves.thinWood = 0.6f;
    useLeaves(leaves, scanClusters);
}

/// Reads the files of measured trees named by `scan`, which are the shapes.
void readScans(TableReader& table, const InputFolders& folders, Species& species) {
    std::vector<std::string> names(1);
    ScanUp up = ScanUp::Found;
    table.readChoice<ScanUp>("up", up, {{"y", ScanUp::Y}, {"z", ScanUp::Z}});
    if (table.has("up") && !table.has("scan"))
        table.problem("up", "cannot be used without scan");
    if (!(table.hasArray("scan") ? table.read("scan", names) : table.read("scan", names.front())))
        return;
    for (const char* key : {"tree", "growth", "habit", "palm", "shapes"})
        if (table.has(key))
            return table.problem(key, "cannot be combined with scan, which defines the shapes");
    std::vector<ScannedTree> scans;
    for (const std::string& name : names)
        if (!addScans(table, folders, name, up, scans))
            return;
    if (scans.empty())
        return table.problem("scan", "expected at least one file");
    species.shapes = static_cast<int>(scans.size());
    useLeavesOnScans(species.tree.leaves);
    species.tree.palm.reset();
    species.tree.growth.reset();
    species.tree.scans = std::make_shared<const std::vector<ScannedTree>>(std::move(scans));
}

/// Adds a note if a species has the name of a built-in one, but neither its shape nor one of its own.
void noteDefaultShape(TableReader& table, DocumentSpecies& known, const std::string& name) {
    for (const char* key : {"like", "tree", "growth", "habit", "palm", "scan"})
        if (table.has(key))
            return;
    if (const Species* builtIn = known.builtIn().find(name))
        table.note("the species " + inQuotes(name) +
                   " has the shape of the thesis' tree; for that of the built-in species, "
                   "set like = " +
                   inQuotes(builtIn->name));
}

/// Reads the tables that describe a tree's form: `tree`, and at most one of the others, which replaces it.
void readForm(TableReader& table, DocumentSpecies& known, Species& species) {
    const char* first = nullptr;
    for (const char* key : {"growth", "habit", "palm"}) {
        if (!table.has(key))
            continue;
        if (first) {
            table.ignoreRest();
            return table.problem(key, std::string("give either this or ") + first);
        }
        first = key;
    }
    TreeParameters& tree = species.tree;
    table.table("tree", [&](TableReader& t) {
        tree.palm.reset();
        tree.growth.reset();
        readWoodShape(t, tree.wood);
    });
    table.table("growth", [&](TableReader& t) {
        const bool palm = isPalm(table, tree), isNew = !tree.palm && !tree.growth;
        readLegacyGrowth(t, known, species, palm);
        if (isNew)
            useLeaves(tree.leaves, palm ? palmClusters : habitClusters);
    });
    table.table("habit", [&](TableReader& t) { readHabit(t, known, tree); });
    table.table("palm", [&](TableReader& t) { readPalm(t, tree); });
}

void addName(TableReader& table, DocumentSpecies& known, const std::string& key, const std::string& name) {
    if (!known.reserveName(name))
        table.problem(key, "the name " + inQuotes(name) + " is taken already");
}

} // namespace

void readSpecies(TableReader& table, const InputFolders& folders, DocumentSpecies& known) {
    Species species;
    std::string like;
    if (table.read("like", like)) {
        if (const Species* model = findTemplate(table, like, known))
            species = *model;
        else
            table.problem("like", "no built-in species " + inQuotes(like));
    }
    if (table.require("name", species.name)) {
        addName(table, known, "name", species.name);
        noteDefaultShape(table, known, species.name);
    }
    species.aliases.clear();
    readScans(table, folders, species);
    readForm(table, known, species);
    bool hasSize = false;
    table.table("leaves", [&](TableReader& t) {
        species.tree.leaves.area = 0.0f;
        readLeafShape(t, species.tree.leaves);
        hasSize = t.has("area") || t.has("length") || t.has("width");
    });
    readKeys(table, species, [&](TableReader& t, const std::string& key, std::string& name) {
        const auto file = folders.open(t, key, name);
        name = file ? file->path : "";
    });
    for (const std::string& alias : species.aliases)
        addName(table, known, "aliases", alias);
    if (!hasSize)
        species.tree.leaves.area =
            species.tree.growth || species.tree.palm || species.tree.scans ? cardAreaRatio(species) : 0.0f;
    known.add(std::move(species));
}

} // namespace osgTreeWind
