// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/MessageText.h>
#include <osgTreeWind/io/NameMatching.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr int usualGrownClusters = 1300;

void readWoodShape(TableReader& table, RecursiveTreeParameters& tree) {
    table.read("levels", tree.levels, within(0, 8));
    table.read("children_per_branch", tree.childrenPerBranch, within(1, 8));
    table.read("trunk_units", tree.trunkUnits, within(1, 16));
    table.read("bare_units", tree.bareUnits, within(0, 15));
    table.read("rings_per_branch", tree.ringsPerBranch, within(2, 64));
    table.read("length", tree.length, within(0.01, 100));
    table.read("length_ratio", tree.lengthRatio, within(0.05, 1.5));
    table.read("bough_length", tree.boughLength, within(0.02, 1.5));
    table.read("crown_taper", tree.crownTaper, within(0.02, 1.5));
    table.read("leader", tree.leader, within(0, 1));
    table.readDegrees("inclination", tree.inclination, within(0, 124));
    table.read("inclination_growth", tree.inclinationGrowth, within(0.05, 3));
    table.read("follow", tree.follow, within(0, 1));
    table.readDegrees("twist", tree.twist, within(-360, 360));
    table.read("jitter", tree.jitter, within(0, 1));
    table.read("crook", tree.crook, within(0, 0.3));
    table.read("radius", tree.radius, within(0.001, 10));
    table.read("taper", tree.taper, within(0.01, 1));
    table.read("radius_ratio", tree.radiusRatio, within(0.01, 1));
    table.read("seed", tree.seed);

    if (tree.radius > 0.5f * tree.length * static_cast<float>(tree.trunkUnits))
        table.problem("radius", "expected at most half the trunk, length * trunk_units");
    if (clamped(tree).levels != tree.levels)
        table.problem("levels", "with children_per_branch and rings_per_branch they make more than " +
                                    std::to_string(maxSkeletonPoints) + " skeleton points");
}

void readBranches(TableReader& table, GrownBranches& branches) {
    table.read("count", branches.count, within(0, 200));
    table.read("units", branches.units, within(1, 3));
    table.read("start", branches.start, within(0, 0.95));
    table.read("length", branches.length, within(0.02, 2));
    table.read("length_variation", branches.lengthVariation, within(0, 1));
    table.readDegrees("inclination", branches.inclination, within(0, 180));
    table.readDegrees("inclination_end", branches.inclinationEnd, within(0, 180));
    table.readDegrees("inclination_variation", branches.inclinationVariation, within(0, 85));
    table.read("flat", branches.flat, within(0, 1));
    table.readDegrees("rise", branches.rise, within(-180, 180));
    table.readDegrees("rise_outside", branches.riseOutside, within(-180, 180));
    table.read("crook", branches.crook, within(0, 1));
    table.read("sections", branches.sections, within(0.01, 2));
    table.read("power", branches.power, within(0, 3));
    table.read("taper", branches.taper, within(0.05, 1));
}

/// Of the trunk at breast height, in place of its radius at the ground.
void readTrunkDiameter(TableReader& table, GrownTreeParameters& tree) {
    constexpr float breastHeight = 1.3f;
    float diameter = 0.0f;
    if (!table.read("trunk_diameter", diameter, within(0.002, 20)))
        return;
    if (table.has("radius"))
        return table.problem("trunk_diameter", "give either this or radius");
    const float length = tree.trunk * tree.height;
    if (!(length > breastHeight))
        return table.problem("trunk_diameter", "expected a trunk, height * trunk, above 1.3 m");
    tree.radius = 0.5f * diameter / (1.0f - (1.0f - tree.trunkTaper) * breastHeight / length);
}

void readGrowth(TableReader& table, GrownTreeParameters& tree) {
    table.read("height", tree.height, within(0.1, 150));
    table.read("radius", tree.radius, within(0.001, 10));
    table.read("trunk", tree.trunk, within(0.05, 1));
    table.read("trunk_units", tree.trunkUnits, within(1, 16));
    table.read("trunk_taper", tree.trunkTaper, within(0.01, 1));
    table.read("trunk_crook", tree.trunkCrook, within(0, 1));
    table.read("forks", tree.forks, within(0, 16));
    table.readDegrees("fork_inclination", tree.forkInclination, within(0, 180));
    table.readChoice<CrownOutline>("shape", tree.shape,
                                   {{"cone", CrownOutline::Cone},
                                    {"sphere", CrownOutline::Sphere},
                                    {"hemisphere", CrownOutline::Hemisphere},
                                    {"cylinder", CrownOutline::Cylinder},
                                    {"tapered_cylinder", CrownOutline::TaperedCylinder},
                                    {"flame", CrownOutline::Flame},
                                    {"inverse_cone", CrownOutline::InverseCone},
                                    {"tend_flame", CrownOutline::TendFlame}});
    table.read("crown_base", tree.crownBase, within(0, 0.95));
    table.read("crown_width", tree.crownWidth, within(0.001, 600));
    table.read("whorl", tree.whorl, within(1, 32));
    table.read("rings_per_branch", tree.ringsPerBranch, within(2, 64));
    table.read("seed", tree.seed);
    table.table("boughs", [&](TableReader& t) { readBranches(t, tree.boughs); });
    table.table("branches", [&](TableReader& t) { readBranches(t, tree.branches); });
    table.table("twigs", [&](TableReader& t) { readBranches(t, tree.twigs); });

    readTrunkDiameter(table, tree);
    if (tree.radius > 0.25f * tree.height)
        table.problem(table.has("trunk_diameter") ? "trunk_diameter" : "radius",
                      "expected at most a quarter of the height");
    if (clamped(tree).twigs.count != tree.twigs.count)
        table.problem("", "boughs, branches and twigs make more than " + std::to_string(maxSkeletonPoints) +
                              " skeleton points");
}

void readLeafShape(TableReader& table, LeafParameters& leaves) {
    if (table.read("clusters_per_branch", leaves.clustersPerBranch, within(0, 64)))
        leaves.clusters = 0;
    table.read("clusters", leaves.clusters, within(0, 100000));
    table.read("bare", leaves.bare, within(0, 0.95));
    table.read("first_level", leaves.firstLevel, within(0, 9));
    table.read("length", leaves.length, within(0.001, 10));
    table.read("width", leaves.width, within(0.001, 10));
    table.read("inner_size", leaves.innerSize, within(0.01, 1));
    table.read("droop", leaves.droop, within(-1, 1));
    table.readDegrees("inclination", leaves.inclination, within(0, 80));
    table.read("thin_wood", leaves.thinWood, within(0, 1));
    table.read("area", leaves.area, within(0, 1e6));
    table.read("seed", leaves.seed);
}

void readWood(TableReader& table, WoodParameters& wood) {
    table.read("elastic_modulus", wood.elasticModulus, within(1e3, 1e12));
    table.read("density", wood.density, within(1, 1e4));
    table.read("damping_ratio", wood.dampingRatio, within(0, 2));
    table.read("under_bark", wood.underBark, within(0.1, 1));
    table.read("whole_stem", wood.wholeStem, within(0.1, 1));
    table.read("branch_modulus", wood.branchModulus, within(0.01, 1));
    table.read("modulus_power", wood.modulusPower, within(0, 2));
    table.read("anchorage", wood.anchorage, within(0, 1e4));
    table.read("leaf_area", wood.leafArea, within(0, 1e5));
    table.read("leaf_mass", wood.leafMass, within(0, 100));
    table.read("wood_drag", wood.woodDrag, within(0, 10));
    table.read("leaf_drag", wood.leafDrag, within(0, 10));
    table.read("still_drag", wood.stillDrag, within(0, 10));
    table.read("crown_drag", wood.crownDrag, within(0, 100));
    table.read("streamlining", wood.streamlining, within(0, 2));
    table.read("streamlined_to", wood.streamlinedTo, within(10, 200));
    table.readChoice<WoodAllometry>("branch_wood", wood.branchWood,
                                    {{"drawn", WoodAllometry::Drawn},
                                     {"conifer", WoodAllometry::Conifer},
                                     {"broadleaf", WoodAllometry::Broadleaf}});
}

void readCrown(TableReader& table, CrownAllometry& crown) {
    table.read("base", crown.base, within(0, 50));
    table.read("per_diameter", crown.perDiameter, within(0, 100));
    table.read("open_base", crown.openBase, within(0, 50));
    table.read("open_per_diameter", crown.openPerDiameter, within(0, 100));
}

void readBranchParameters(TableReader& table, BranchParameters& branch) {
    table.readDegrees("max_angle", branch.maxAngle, within(0, 90));
    table.read("partial_steps", branch.partialSteps, within(1, 10000));
    table.read("level_factor", branch.levelFactor, within(-100, 100));
    table.read("noise_frequency", branch.noiseFrequency, within(0, 100));
}

void readLeafMotion(TableReader& table, LeafMotion& leaf) {
    table.readDegrees("max_angle_x", leaf.maxAngleX, within(0, 90));
    table.readDegrees("max_angle_z", leaf.maxAngleZ, within(0, 90));
    table.readDegrees("max_rotation", leaf.maxRotation, within(0, 180));
    table.read("partial_steps", leaf.partialSteps, within(1, 10000));
    table.read("factor", leaf.factor, within(0, 1));
    table.read("linked_factor", leaf.linkedFactor, within(-10, 10));
    table.read("noise_frequency", leaf.noiseFrequency, within(0, 100));
}

void readPicture(TableReader& table, const char* key, ForestReading& reading, std::string& path) {
    std::string name;
    if (table.read(key, name))
        if (const auto file = reading.open(table, key, name))
            path = file->path;
}

void readAppearance(TableReader& table, Appearance& appearance, ForestReading& reading) {
    table.read("bark", appearance.bark, within(0, 1));
    table.read("leaves", appearance.leaves, within(0, 1));
    table.read("spring_leaves", appearance.springLeaves, within(0, 1));
    table.read("autumn_leaves", appearance.autumnLeaves, within(0, 1));
    if (bool evergreen = false; table.read("evergreen", evergreen))
        appearance.evergreen = evergreen;
    table.readChoice<LeafForm>("leaf_form", appearance.leafForm,
                               {{"blade", LeafForm::Blade},
                                {"lobed", LeafForm::Lobed},
                                {"ovate", LeafForm::Ovate},
                                {"rhombic", LeafForm::Rhombic},
                                {"palmate", LeafForm::Palmate},
                                {"pinnate", LeafForm::Pinnate},
                                {"heart", LeafForm::Heart},
                                {"round", LeafForm::Round},
                                {"fingered", LeafForm::Fingered},
                                {"fan", LeafForm::Fan},
                                {"needles", LeafForm::Needles},
                                {"bundles", LeafForm::Bundles},
                                {"tufts", LeafForm::Tufts},
                                {"frond", LeafForm::Frond}});
    table.readChoice<BarkForm>("bark_form", appearance.barkForm,
                               {{"furrowed", BarkForm::Furrowed},
                                {"plated", BarkForm::Plated},
                                {"smooth", BarkForm::Smooth},
                                {"banded", BarkForm::Banded},
                                {"flaking", BarkForm::Flaking},
                                {"ringed", BarkForm::Ringed}});
    readPicture(table, "leaf_image", reading, appearance.leafImage);
    readPicture(table, "bark_image", reading, appearance.barkImage);
}

constexpr int mostShapes = 64;

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
        report.source = std::filesystem::path(found->path).filename().string();
        if (trees.size() > 1)
            report.source += ", tree " + std::to_string(i + 1);
    }
    return true;
}

/// A scan knows of no leaves: those of the species, so many as on a built-in tree, on the thinner wood.
void spreadOnScans(LeafParameters& leaves) {
    leaves.firstLevel = 0;
    leaves.clusters = usualGrownClusters;
    leaves.bare = 0.0f;
    leaves.thinWood = 0.6f;
    if (!(leaves.inclination > 0.0f))
        leaves.inclination = 0.6f;
}

/// `scan`: a file of measured trees, or several. They are the shapes.
void readScans(TableReader& table, ForestReading& reading, Species& species) {
    std::vector<std::string> names(1);
    const bool given = table.hasArray("scan") ? table.read("scan", names) : table.read("scan", names.front());
    if (!given)
        return;
    for (const char* key : {"tree", "growth", "shapes"})
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
    species.tree.scans = std::make_shared<const std::vector<ScannedTree>>(std::move(scans));
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
    if (table.require("name", species.name))
        addName(table, reading, "name", species.name);
    species.aliases.clear();
    table.read("aliases", species.aliases);
    for (const std::string& alias : species.aliases)
        addName(table, reading, "aliases", alias);
    table.read("source", species.source);

    table.read("shapes", species.shapes, within(1, mostShapes));
    readScans(table, reading, species);
    table.table("tree", [&](TableReader& t) {
        species.tree.grown.reset();
        readWoodShape(t, species.tree.wood);
    });
    table.table("growth", [&](TableReader& t) {
        if (!species.tree.grown)
            species.tree.leaves.clusters = usualGrownClusters;
        readGrowth(t, species.tree.grown ? *species.tree.grown : species.tree.grown.emplace());
    });
    bool sized = false;
    table.table("leaves", [&](TableReader& t) {
        species.tree.leaves.area = 0.0f;
        readLeafShape(t, species.tree.leaves);
        sized = t.has("area") || t.has("length") || t.has("width");
    });
    table.table("crown", [&](TableReader& t) { readCrown(t, species.crown); });
    table.table("wood", [&](TableReader& t) { readWood(t, species.wood); });
    table.table("branch", [&](TableReader& t) { readBranchParameters(t, species.branch); });
    table.table("leaf", [&](TableReader& t) { readLeafMotion(t, species.leaf); });
    table.table("appearance", [&](TableReader& t) { readAppearance(t, species.appearance, reading); });
    if (!sized)
        species.tree.leaves.area = species.tree.grown || species.tree.scans ? cardArea(species) : 0.0f;
    reading.forest.species.push_back(std::move(species));
}

} // namespace osgTreeWind
