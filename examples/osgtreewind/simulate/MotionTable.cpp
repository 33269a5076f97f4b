// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/simulate/MotionTable.h>

#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/RotationAbout.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/FootLoad.h>

#include <algorithm>
#include <limits>

using namespace osgTreeWind;

namespace {

/// Adds columns for the coordinates of a vector, with the suffixes _x, _y and _z. @param words meaning, in
/// which the axis replaces "AXIS". @param axes number of coordinates, 2 or 3.
void addVector(std::vector<MotionColumn>& columns, const std::string& name, const char* unit,
               const std::string& words, std::size_t axes = 3, bool isPlace = false, bool isFixed = false) {
    const char* const towards[] = {"towards east", "towards north", "upward"};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        std::string meaning = words;
        meaning.replace(meaning.find("AXIS"), 4, towards[axis]);
        columns.push_back({name + "_" + "xyz"[axis], unit, meaning, isPlace, isFixed});
    }
}

const Skeleton& skeletonOf(const ForestSimulation& simulation, TreeId tree) {
    return simulation.skeleton(*simulation.modelOf(tree));
}

/// Where a point of a tree at rest is in the scene, metres. @param pose of its unit.
glm::vec3 sceneOf(const PlacedTree& tree, const glm::vec3& rest, const UnitPose& pose = {}) {
    const glm::quat heading = rotationAbout(up, tree.heading);
    return tree.position + heading * pose.apply(tree.scale.axes * rest);
}

const PlacedTree& placed(const ForestSimulation& simulation, TreeId tree) {
    return movingForest(simulation).trees()[slotOfTree(tree)];
}

/// NaN for an unknown limit.
double knownLimit(double limit) {
    return limit > 0.0 ? limit : std::numeric_limits<double>::quiet_NaN();
}

template <typename... Numbers>
float* put(float* values, Numbers... numbers) {
    ((*values++ = static_cast<float>(numbers)), ...);
    return values;
}

MotionTable emptyTable(const char* title, const std::vector<TreeId>& trees) {
    MotionTable table;
    table.title = title;
    table.trees = trees;
    table.firstRows.push_back(0);
    return table;
}

/// A row for each tree.
MotionTable treeTable(const char* title, const std::vector<TreeId>& trees) {
    MotionTable table = emptyTable(title, trees);
    for (std::size_t i = 1; i <= trees.size(); ++i)
        table.firstRows.push_back(i);
    return table;
}

/// A row for each unit. @param units see MotionTable.
MotionTable unitTable(const char* title, const ForestSimulation& simulation, const std::vector<TreeId>& trees,
                      const std::vector<std::size_t>& units = {}) {
    MotionTable table = emptyTable(title, trees);
    table.isOfUnits = true;
    table.units = units;
    for (const TreeId tree : trees) {
        const std::size_t count = skeletonOf(simulation, tree).units.size();
        for (const std::size_t unit : units)
            if (unit >= count)
                throw CommandError{BadInput, "--units: expected numbers below " + std::to_string(count) +
                                                 " for tree " + std::to_string(slotOfTree(tree)) +
                                                 ", found " + std::to_string(unit)};
        table.firstRows.push_back(table.rowCount() + (units.empty() ? count : units.size()));
    }
    return table;
}

} // namespace

void MotionTable::values(const ForestSimulation& simulation, std::size_t first, std::size_t end,
                         std::vector<float>& result) const {
    constexpr std::size_t treesPerJob = 16;
    const std::size_t before = firstRows[first], jobs = (end - first + treesPerJob - 1) / treesPerJob;
    result.resize((firstRows[end] - before) * columns.size());
    runJobs(simulation.executor(), jobs, [&](std::size_t job) {
        const std::size_t from = first + job * treesPerJob;
        for (std::size_t tree = from; tree < std::min(from + treesPerJob, end); ++tree)
            fill(simulation, trees[tree], result.data() + (firstRows[tree] - before) * columns.size());
    });
}

MotionTable branchTable(const ForestSimulation& simulation, const std::vector<TreeId>& trees, bool tips) {
    MotionTable table = unitTable("Motion of branches", simulation, trees);
    table.hasLevels = true;
    addVector(table.columns, "wind", "m s-1", "wind AXIS");
    table.columns.push_back({"angle_a", "rad", "angleXY of the thesis; law modal: about the first axis"});
    table.columns.push_back({"angle_b", "rad", "angleYZ of the thesis; law modal: about the second axis"});
    if (tips)
        addVector(table.columns, "tip", "m", "tip of the unit in the scene, AXIS", 3, true);
    table.fill = [tips](const ForestSimulation& forest, TreeId id, float* values) {
        thread_local UnitValues memory;
        const PlacedTree& tree = placed(forest, id);
        const std::vector<BranchUnit>& units = skeletonOf(forest, id).units;
        const TreeMotion motion = forest.motion(id, memory);
        for (std::size_t u = 0; u < units.size(); ++u) {
            const glm::vec3& wind = motion.winds[u];
            values = put(values, wind.x, wind.y, wind.z, motion.states[u].x, motion.states[u].y);
            if (!tips)
                continue;
            const glm::vec3 tip = sceneOf(tree, units[u].tip, motion.poses[u]);
            values = put(values, tip.x, tip.y, tip.z);
        }
    };
    return table;
}

MotionTable topTable(const ForestSimulation& simulation, const std::vector<TreeId>& trees) {
    MotionTable table = treeTable("Motion of treetops", trees);
    addVector(table.columns, "top", "m", "top of the tree in the scene, AXIS", 3, true);
    addVector(table.columns, "rest", "m", "top of the tree at rest in the scene, AXIS", 3, true, true);
    std::vector<std::size_t> topUnits; // by model
    for (std::size_t model = 0; model < simulation.modelCount(); ++model)
        topUnits.push_back(highestUnit(simulation.skeleton(model)));
    table.fill = [topUnits](const ForestSimulation& forest, TreeId id, float* values) {
        const PlacedTree& tree = placed(forest, id);
        const std::size_t unit = topUnits[tree.model];
        const glm::vec3& tip = skeletonOf(forest, id).units[unit].tip;
        const glm::vec3 top = sceneOf(tree, tip, forest.unitMotion(id, unit).pose), rest = sceneOf(tree, tip);
        put(values, top.x, top.y, top.z, rest.x, rest.y, rest.z);
    };
    return table;
}

MotionTable loadTable(const std::vector<TreeId>& trees) {
    MotionTable table = treeTable("Sway of trees and moments at their feet", trees);
    addVector(table.columns, "wind", "m s-1", "wind AXIS at the top, undisturbed by the tree");
    addVector(table.columns, "shift", "m", "displacement of the top from rest AXIS", 2);
    addVector(table.columns, "velocity", "m s-1", "velocity of the top by sway, AXIS", 2);
    table.columns.push_back(
        {"lean", "rad", "angle between the lines from the foot to the top now and at rest"});
    addVector(table.columns, "moment", "N m",
              "moment of wind, inertia and overhanging weight at the foot; positive turns the tree AXIS", 2);
    addVector(table.columns, "weight_moment", "N m",
              "part of the moment by the overhanging weight; positive turns the tree AXIS", 2);
    table.columns.push_back({"limit", "N m", "moment that uproots or breaks the tree"});
    table.columns.push_back({"frequency", "Hz", "natural frequency of the main mode"});
    const std::size_t count = table.columns.size();
    table.fill = [count](const ForestSimulation& forest, TreeId id, float* values) {
        const std::optional<TreeSway> sway = forest.sway(id);
        if (!sway) {
            std::fill_n(values, count, std::numeric_limits<float>::quiet_NaN());
            return;
        }
        const glm::dvec2 moment = sway->windMoment + sway->weightMoment;
        put(values, sway->windAtTop.x, sway->windAtTop.y, sway->windAtTop.z, sway->displacement.x,
            sway->displacement.y, sway->velocity.x, sway->velocity.y, sway->lean, moment.x, moment.y,
            sway->weightMoment.x, sway->weightMoment.y, knownLimit(sway->limit), sway->frequency);
    };
    return table;
}

MotionTable unitLoadTable(const ForestSimulation& simulation, const std::vector<TreeId>& trees,
                          const std::vector<std::size_t>& units) {
    MotionTable table = unitTable("Moments at branches", simulation, trees, units);
    addVector(
        table.columns, "moment", "N m",
        "moment of wind, inertia and weight at the base of the unit beyond that at rest; positive turns "
        "its tip AXIS");
    addVector(
        table.columns, "strain", "1",
        "largest strain of the wood at the base of the unit as its tip turns AXIS; tension on the other "
        "side");
    addVector(table.columns, "tilt", "1", "direction of the unit, a unit vector, minus that at rest, AXIS");
    table.columns.push_back(
        {"limit", "N m", "moment at which a bough tears off or, at the foot, the tree falls"});
    const std::size_t count = table.columns.size();
    table.fill = [units, count](const ForestSimulation& forest, TreeId id, float* values) {
        const std::vector<BranchLoad> loads = forest.branchLoads(id);
        if (loads.empty())
            std::fill_n(values, units.size() * count, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = 0; i < units.size() && !loads.empty(); ++i) {
            const BranchLoad& load = loads[units[i]];
            const glm::dvec3 strain = load.strain * load.moment;
            values = put(values, load.moment.x, load.moment.y, load.moment.z, strain.x, strain.y, strain.z,
                         load.tilt.x, load.tilt.y, load.tilt.z, knownLimit(load.limit));
        }
    };
    return table;
}
