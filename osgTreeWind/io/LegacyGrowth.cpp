// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/LegacyGrowth.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/model/PalmTree.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>

namespace osgTreeWind {
namespace {

constexpr float breastHeight = 1.3f;
constexpr float minLeaderTrunk = 0.8f; ///< Share of the height from which a trunk reaches the top.
constexpr float wanderPerCrook = 0.5f; ///< Radians per metre for each unit of crook.

/// Parameters of the branches of one order; empty: not given.
struct LegacyBranches {
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

LegacyBranches readBranches(TableReader& growth, const char* key) {
    LegacyBranches branches;
    growth.table(key, [&](TableReader& table) {
        branches.count = number(table, "count", within(0, 200));
        branches.inclination = angle(table, "inclination", within(0, 180));
        branches.inclinationEnd = angle(table, "inclination_end", within(0, 180));
        branches.flat = number(table, "flat", within(0, 1));
        branches.rise = angle(table, "rise", within(-180, 180));
        branches.riseOutside = angle(table, "rise_outside", within(-180, 180));
        branches.crook = number(table, "crook", within(0, 1));
        table.ignoreRest(); // lengths, units and thicknesses, which now result from growth
    });
    return branches;
}

/// All values of the table.
struct LegacyGrowth {
    std::optional<float> height, radius, trunkDiameter, crownWidth, crownBase, trunk, trunkTaper, trunkCrook;
    std::optional<float> flare, forks, whorl;
    std::optional<std::uint32_t> seed;
    std::string shape;
    std::array<LegacyBranches, 3> branches; ///< Boughs, branches, twigs.

    explicit LegacyGrowth(TableReader& table)
        : height(number(table, "height", within(0.1, 150))),
          radius(number(table, "radius", within(0.001, 10))),
          trunkDiameter(number(table, "trunk_diameter", within(0.002, 20))),
          crownWidth(number(table, "crown_width", within(0.001, 600))),
          crownBase(number(table, "crown_base", within(0, 0.95))),
          trunk(number(table, "trunk", within(0.05, 1))),
          trunkTaper(number(table, "trunk_taper", within(0.01, 1))),
          trunkCrook(number(table, "trunk_crook", within(0, 1))), flare(number(table, "flare", within(0, 3))),
          forks(number(table, "forks", within(0, 16))), whorl(number(table, "whorl", within(1, 32))) {
        if (std::uint32_t value = 0; table.read("seed", value))
            seed = value;
        table.read("shape", shape);
        branches = {readBranches(table, "boughs"), readBranches(table, "branches"),
                    readBranches(table, "twigs")};
        if (radius && trunkDiameter)
            table.problem("trunk_diameter", "give either this or radius");
        table.ignoreRest();
    }

    float diameterAtBreast(float defaultDiameter, float defaultHeight) const {
        if (trunkDiameter || !radius)
            return trunkDiameter.value_or(defaultDiameter);
        const float length = std::max(trunk.value_or(0.75f) * height.value_or(defaultHeight), breastHeight);
        return 2.0f * *radius * (1.0f - (1.0f - trunkTaper.value_or(0.5f)) * breastHeight / length);
    }
};

template <typename T, typename Value>
void set(T& field, const std::optional<Value>& value) {
    if (value)
        field = static_cast<T>(*value);
}

/// TreeHabit::rounding for a crown shape.
std::optional<float> roundingOf(const std::string& shape) {
    static const std::map<std::string, float> roundings = {
        {"cone", 0.1f},  {"sphere", 0.7f},           {"hemisphere", 0.8f}, {"cylinder", 0.4f},
        {"flame", 0.3f}, {"tapered_cylinder", 0.3f}, {"tend_flame", 0.4f}, {"inverse_cone", 0.9f}};
    const auto found = roundings.find(shape);
    return found == roundings.end() ? std::nullopt : std::optional(found->second);
}

/// @param bearer order of the parent branches. @param length typical length of the branches, metres.
void setBranches(TreeHabit& habit, std::size_t bearer, const LegacyBranches& legacy, float length) {
    const std::size_t order = bearer + 1;
    if (legacy.inclination || legacy.inclinationEnd)
        habit.branchAngle[bearer] = 0.5f * (legacy.inclination.value_or(legacy.inclinationEnd.value_or(0)) +
                                            legacy.inclinationEnd.value_or(legacy.inclination.value_or(0)));
    set(habit.flat[bearer], legacy.flat);
    if (legacy.crook)
        habit.wander[order] = wanderPerCrook * *legacy.crook;
    if (legacy.rise || legacy.riseOutside) {
        const float turn = (legacy.rise.value_or(0) + legacy.riseOutside.value_or(0)) / length;
        habit.rise[order] = std::max(turn, 0.0f);
        habit.hang[order] = std::max(-turn, 0.0f);
    }
}

void setHabit(const LegacyGrowth& legacy, GrowthParameters& growth) {
    GrowthGoal& size = growth.size;
    size.trunkDiameter = legacy.diameterAtBreast(size.trunkDiameter, size.height);
    set(size.height, legacy.height);
    set(size.crownWidth, legacy.crownWidth);
    set(growth.flare, legacy.flare);
    set(growth.seed, legacy.seed);
    TreeHabit& habit = growth.habit;
    set(habit.cleanStem, legacy.crownBase);
    set(habit.rounding, roundingOf(legacy.shape));
    if (legacy.trunk)
        habit.trunkTop = *legacy.trunk < minLeaderTrunk ? *legacy.trunk : 1.0f;
    if (legacy.forks && *legacy.forks >= 2.0f)
        habit.limbs = static_cast<int>(*legacy.forks);
    if (legacy.whorl && *legacy.whorl > 1.0f)
        habit.whorl = *legacy.whorl;
    if (legacy.trunkCrook)
        habit.wander[0] = wanderPerCrook * *legacy.trunkCrook;
    float length = std::max(0.5f * size.crownWidth, 0.1f);
    for (std::size_t bearer = 0; bearer < legacy.branches.size(); ++bearer, length *= 0.5f)
        setBranches(habit, bearer, legacy.branches[bearer], length);
    growth = clampedKeys(growth);
}

void setPalm(const LegacyGrowth& legacy, PalmParameters& palm) {
    palm.trunkDiameter = legacy.diameterAtBreast(palm.trunkDiameter, palm.height);
    set(palm.height, legacy.height);
    set(palm.crownWidth, legacy.crownWidth);
    set(palm.crownBase, legacy.crownBase);
    set(palm.trunk, legacy.trunk);
    set(palm.trunkTaper, legacy.trunkTaper);
    set(palm.trunkCrook, legacy.trunkCrook);
    set(palm.flare, legacy.flare);
    set(palm.seed, legacy.seed);
    const LegacyBranches& fronds = legacy.branches.front();
    set(palm.fronds, fronds.count);
    set(palm.inclination, fronds.inclination);
    set(palm.inclinationEnd, fronds.inclinationEnd);
    if (fronds.rise || fronds.riseOutside)
        palm.droop = -fronds.rise.value_or(0) - fronds.riseOutside.value_or(0);
    palm = clamped(palm);
}

/// The species whose habit is the starting point for a species without `like`.
const Species& nearestHabit(const LegacyGrowth& legacy, const Species& species, DocumentSpecies& known) {
    if (const Species* namesake = known.builtIn().find(species.name); namesake && namesake->tree.growth)
        return *namesake;
    const bool leader = legacy.trunk.value_or(0.75f) >= minLeaderTrunk;
    return *known.builtIn().find(leader && legacy.shape == "cone" ? "conifer" : "broadleaf");
}

} // namespace

void readLegacyGrowth(TableReader& table, DocumentSpecies& known, Species& species, bool isPalm) {
    const LegacyGrowth legacy(table);
    if (!legacy.shape.empty() && !roundingOf(legacy.shape))
        table.problem("shape", "no crown shape is called " + inQuotes(legacy.shape));
    TreeParameters& tree = species.tree;
    if (isPalm) {
        setPalm(legacy, tree.palm ? *tree.palm : tree.palm.emplace());
        tree.growth.reset();
    } else {
        if (!tree.growth)
            tree.growth = nearestHabit(legacy, species, known).tree.growth;
        setHabit(legacy, *tree.growth);
        tree.palm.reset();
    }
    table.note("species " + inQuotes(species.name) + ": [species.growth] of version 1 is read as " +
               (isPalm ? "[species.palm]" : "[species.habit]") +
               ": its size is kept, angles and bends are approximated, and the rest of the form is grown");
}

} // namespace osgTreeWind
