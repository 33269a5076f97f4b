// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/FormerGrowth.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/growth/GrowthFields.h>
#include <osgTreeWind/model/PalmTree.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>

namespace osgTreeWind {
namespace {

constexpr float breastHeight = 1.3f;
constexpr float leaderFrom = 0.8f;    ///< A trunk of this share of the height went on to the top.
constexpr float wanderOfCrook = 0.5f; ///< Radians in a metre for each unit of crook.

/// What told the branches of one order; no value: not given.
struct FormerBranches {
    std::optional<float> inclination, inclinationEnd, flat, rise, riseOutside, crook;
    std::optional<float> count;
};

std::optional<float> number(TableReader& table, const char* key, const Range& range) {
    float value = 0.0f;
    return table.read(key, value, range) ? std::optional(value) : std::nullopt;
}

std::optional<float> angle(TableReader& table, const char* key, const Range& range) {
    float radians = 0.0f;
    return table.readDegrees(key, radians, range) ? std::optional(radians) : std::nullopt;
}

FormerBranches readBranches(TableReader& growth, const char* key) {
    FormerBranches branches;
    growth.table(key, [&](TableReader& table) {
        branches.count = number(table, "count", within(0, 200));
        branches.inclination = angle(table, "inclination", within(0, 180));
        branches.inclinationEnd = angle(table, "inclination_end", within(0, 180));
        branches.flat = number(table, "flat", within(0, 1));
        branches.rise = angle(table, "rise", within(-180, 180));
        branches.riseOutside = angle(table, "rise_outside", within(-180, 180));
        branches.crook = number(table, "crook", within(0, 1));
        table.ignoreRest(); // lengths, units and thicknesses, which follow from growth
    });
    return branches;
}

/// All that a table said.
struct FormerGrowth {
    std::optional<float> height, radius, trunkDiameter, crownWidth, crownBase, trunk, trunkTaper, trunkCrook;
    std::optional<float> flare, forks, whorl;
    std::optional<std::uint32_t> seed;
    std::string shape;
    std::array<FormerBranches, 3> branches; ///< Boughs, branches, twigs.

    explicit FormerGrowth(TableReader& table)
        : height(number(table, "height", within(0.1, 150))),
          radius(number(table, "radius", within(0.001, 10))),
          trunkDiameter(number(table, "trunk_diameter", within(0.002, 20))),
          crownWidth(number(table, "crown_width", within(0.001, 600))),
          crownBase(number(table, "crown_base", within(0, 0.95))),
          trunk(number(table, "trunk", within(0.05, 1))),
          trunkTaper(number(table, "trunk_taper", within(0.01, 1))),
          trunkCrook(number(table, "trunk_crook", within(0, 1))), flare(number(table, "flare", within(0, 3))),
          forks(number(table, "forks", within(0, 16))), whorl(number(table, "whorl", within(1, 32))) {
        if (std::uint32_t given = 0; table.read("seed", given))
            seed = given;
        table.read("shape", shape);
        branches = {readBranches(table, "boughs"), readBranches(table, "branches"),
                    readBranches(table, "twigs")};
        if (radius && trunkDiameter)
            table.problem("trunk_diameter", "give either this or radius");
        table.ignoreRest();
    }

    /// @param usual where it is not given.
    float diameterAtBreast(float usual, float usualHeight) const {
        if (trunkDiameter || !radius)
            return trunkDiameter.value_or(usual);
        const float length = std::max(trunk.value_or(0.75f) * height.value_or(usualHeight), breastHeight);
        return 2.0f * *radius * (1.0f - (1.0f - trunkTaper.value_or(0.5f)) * breastHeight / length);
    }
};

template <typename T, typename Given>
void set(T& field, const std::optional<Given>& given) {
    if (given)
        field = static_cast<T>(*given);
}

/// How much shoots slow down as they come to the outside of a crown of that shape.
std::optional<float> roundingOf(const std::string& shape) {
    static const std::map<std::string, float> roundings = {
        {"cone", 0.1f},  {"sphere", 0.7f},           {"hemisphere", 0.8f}, {"cylinder", 0.4f},
        {"flame", 0.3f}, {"tapered_cylinder", 0.3f}, {"tend_flame", 0.4f}, {"inverse_cone", 0.9f}};
    const auto found = roundings.find(shape);
    return found == roundings.end() ? std::nullopt : std::optional(found->second);
}

/// @param bearer order of what bears these branches. @param length that they usually have, metres.
void setBranches(TreeHabit& habit, std::size_t bearer, const FormerBranches& former, float length) {
    const std::size_t order = bearer + 1;
    if (former.inclination || former.inclinationEnd)
        habit.branchAngle[bearer] = 0.5f * (former.inclination.value_or(former.inclinationEnd.value_or(0)) +
                                            former.inclinationEnd.value_or(former.inclination.value_or(0)));
    set(habit.flat[bearer], former.flat);
    if (former.crook)
        habit.wander[order] = wanderOfCrook * *former.crook;
    if (former.rise || former.riseOutside) {
        const float turn = (former.rise.value_or(0) + former.riseOutside.value_or(0)) / length;
        habit.rise[order] = std::max(turn, 0.0f);
        habit.hang[order] = std::max(-turn, 0.0f);
    }
}

void setHabit(const FormerGrowth& former, GrowthParameters& growth) {
    GrowthGoal& size = growth.size;
    size.trunkDiameter = former.diameterAtBreast(size.trunkDiameter, size.height);
    set(size.height, former.height);
    set(size.crownWidth, former.crownWidth);
    set(growth.flare, former.flare);
    set(growth.seed, former.seed);
    TreeHabit& habit = growth.habit;
    set(habit.cleanStem, former.crownBase);
    set(habit.rounding, roundingOf(former.shape));
    if (former.trunk)
        habit.trunkTop = *former.trunk < leaderFrom ? *former.trunk : 1.0f;
    if (former.forks && *former.forks >= 2.0f)
        habit.limbs = static_cast<int>(*former.forks);
    if (former.whorl && *former.whorl > 1.0f)
        habit.whorl = *former.whorl;
    if (former.trunkCrook)
        habit.wander[0] = wanderOfCrook * *former.trunkCrook;
    float length = std::max(0.5f * size.crownWidth, 0.1f);
    for (std::size_t bearer = 0; bearer < former.branches.size(); ++bearer, length *= 0.5f)
        setBranches(habit, bearer, former.branches[bearer], length);
    growth = clampedFields(growth);
}

void setPalm(const FormerGrowth& former, PalmParameters& palm) {
    palm.trunkDiameter = former.diameterAtBreast(palm.trunkDiameter, palm.height);
    set(palm.height, former.height);
    set(palm.crownWidth, former.crownWidth);
    set(palm.crownBase, former.crownBase);
    set(palm.trunk, former.trunk);
    set(palm.trunkTaper, former.trunkTaper);
    set(palm.trunkCrook, former.trunkCrook);
    set(palm.flare, former.flare);
    set(palm.seed, former.seed);
    const FormerBranches& fronds = former.branches.front();
    set(palm.fronds, fronds.count);
    set(palm.inclination, fronds.inclination);
    set(palm.inclinationEnd, fronds.inclinationEnd);
    if (fronds.rise || fronds.riseOutside)
        palm.droop = -fronds.rise.value_or(0) - fronds.riseOutside.value_or(0);
    palm = clamped(palm);
}

/// The habit from which a species starts that is like no other.
const Species& nearestHabit(const FormerGrowth& former, const Species& species, ForestReading& reading) {
    if (const Species* namesake = reading.builtIn().find(species.name); namesake && namesake->tree.growth)
        return *namesake;
    const bool leader = former.trunk.value_or(0.75f) >= leaderFrom;
    return *reading.builtIn().find(leader && former.shape == "cone" ? "conifer" : "broadleaf");
}

} // namespace

void readFormerGrowth(TableReader& table, ForestReading& reading, Species& species, bool palm) {
    const FormerGrowth former(table);
    if (!former.shape.empty() && !roundingOf(former.shape))
        table.problem("shape", "no outline of a crown is called " + inQuotes(former.shape));
    TreeParameters& tree = species.tree;
    if (palm) {
        setPalm(former, tree.palm ? *tree.palm : tree.palm.emplace());
        tree.growth.reset();
    } else {
        if (!tree.growth)
            tree.growth = nearestHabit(former, species, reading).tree.growth;
        setHabit(former, *tree.growth);
        tree.palm.reset();
    }
    reading.forest.notes.push_back(
        "species " + inQuotes(species.name) + ": [species.growth] of version 1 is read as " +
        (palm ? "[species.palm]" : "[species.habit]") +
        ": the size holds, angles and bends became the nearest numbers, and the rest of the form grows");
}

} // namespace osgTreeWind
