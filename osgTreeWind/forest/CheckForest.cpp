// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CheckForest.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t maxProblems = 100;

void add(Diagnostics& problems, const std::string& key, const std::string& message) {
    problems.push_back(keyProblem(key, message));
}

void checkText(const std::string& text, const std::string& key, Diagnostics& problems) {
    if (!isUtf8(text))
        add(problems, key, "expected UTF-8");
}

/// Reports values out of range, or if there are none, conflicts between values.
template <typename Struct>
void checkStruct(const Struct& value, const std::string& path, Diagnostics& problems) {
    const std::size_t before = problems.size();
    checkKeys(value, path, problems);
    if (problems.size() == before)
        for (const KeyConflict& conflict : conflictsOf(value))
            add(problems, path + (conflict.key.empty() ? "" : '.' + conflict.key), conflict.message);
}

void checkPlace(const glm::dvec3& place, const std::string& key, Diagnostics& problems) {
    for (int axis = 0; axis < 3; ++axis)
        if (!worldCoordinates.contains(place[axis]))
            return add(problems, key,
                       "expected finite numbers " + worldCoordinates.text() + ", found " +
                           numberText(place[axis]));
}

void checkScans(const std::vector<ScannedTree>& scans, const std::string& key, Diagnostics& problems) {
    if (scans.empty())
        add(problems, key, "expected at least one");
    for (std::size_t i = 0; i < scans.size(); ++i)
        if (const std::string problem = problemOfSkeleton(scans[i].skeleton); !problem.empty())
            add(problems, key + '[' + std::to_string(i) + ']', problem);
}

void checkTiles(const ForestTiles& tiles, Diagnostics& problems) {
    const auto expect = [&](const char* key, double value, const Range& range) {
        if (!range.contains(value))
            add(problems, std::string("tiles.") + key,
                "expected a finite number " + range.text() + ", found " + numberText(value));
    };
    expect("size", tiles.size, tileSizes);
    expect("range", tiles.range, tileSizes);
    expect("columns", tiles.columns, tileCounts);
    expect("rows", tiles.rows(), tileCounts);
    expect("id_files", tiles.idFiles, tileIdFiles);
    checkPlace({tiles.corner, 0.0}, "tiles.corner", problems);
    if (tiles.columns > 0 && tiles.tiles.size() % tiles.columns != 0)
        add(problems, "tiles.trees", "expected whole rows");
    for (const ForestTiles::Tile& tile : tiles.tiles)
        if (!worldCoordinates.contains(static_cast<double>(tile.low)) ||
            !worldCoordinates.contains(static_cast<double>(tile.high)))
            return add(problems, "tiles.low", "expected finite numbers " + worldCoordinates.text());
}

void checkMotion(const ForestDescription& forest, Diagnostics& problems) {
    checkKeys(forest, "motion", problems);
    if (forest.damage && forest.law != MotionLaw::Modal)
        add(problems, "motion.damage", "expected false, since the law is not \"modal\"");
    if (forest.tiles && forest.law != MotionLaw::Modal)
        add(problems, "tiles", "expected the law \"modal\" with tiles");
    if (forest.noiseExponent && !noiseExponents.contains(static_cast<double>(*forest.noiseExponent)))
        add(problems, "motion.noise_exponent", "expected a finite number " + noiseExponents.text());
}

/// Appends the problems of an element of a list, with its path prepended to their keys.
void addPartProblems(Diagnostics&& partProblems, const char* list, std::size_t index, Diagnostics& problems) {
    for (Diagnostic& problem : partProblems) {
        problem.key = std::string(list) + '[' + std::to_string(index) + "]." + problem.key;
        problems.push_back(std::move(problem));
    }
}

} // namespace

Diagnostics check(const Species& species) {
    Diagnostics problems;
    checkText(species.name, "name", problems);
    for (const std::string& alias : species.aliases)
        checkText(alias, "aliases", problems);
    checkText(species.source, "source", problems);
    checkText(species.height.source, "height.source", problems);
    checkKeys(species, "", problems);
    checkStruct(species.tree.wood, "tree", problems);
    if (species.tree.palm)
        checkStruct(*species.tree.palm, "palm", problems);
    if (species.tree.growth)
        checkKeys(*species.tree.growth, "habit", problems);
    if (species.tree.scans)
        checkScans(*species.tree.scans, "scan", problems);
    checkKeys(species.tree.leaves, "leaves", problems);
    return problems;
}

Diagnostics check(const TreePlacement& tree, const ForestDescription& forest) {
    Diagnostics problems;
    if (tree.species >= forest.species.size())
        add(problems, "species",
            "there is no species " + std::to_string(tree.species) + "; the forest has " +
                std::to_string(forest.species.size()) + ", from 0 on");
    checkText(tree.name, "id", problems);
    checkPlace(tree.position, "position", problems);
    if (problems.empty() && !(glm::distance(tree.position, forest.origin) <= maxTreeDistance))
        add(problems, "position", "expected at most 100 km from the origin");
    TreePlacement given = tree;
    for (float* size : {&given.size.height, &given.size.trunkDiameter, &given.size.crownWidth})
        if (*size <= 0.0f && std::isfinite(*size))
            *size = 1.0f; // not given
    checkKeys(given, "", problems);
    return problems;
}

Diagnostics check(const ForestDescription& forest) {
    Diagnostics problems;
    checkText(forest.hostCrs, "host_crs", problems);
    if (!forest.crs.empty())
        if (const auto crs = Crs::parseMap(forest.crs); !crs)
            problems.push_back(crs.problems().front());
    checkMotion(forest, problems);
    if (!frameSteps.contains(forest.step))
        add(problems, "step", "expected a finite number " + frameSteps.text());
    checkStruct(forest.drawing, "drawing", problems);
    checkKeys(forest.canopy, "wind", problems);
    for (Diagnostic& problem : check(forest.wind))
        problems.push_back(std::move(problem));
    if (!seasons.contains(static_cast<double>(forest.season)))
        add(problems, "season", "expected a finite number " + seasons.text());
    checkPlace(forest.origin, "origin", problems);
    if (forest.tiles)
        checkTiles(*forest.tiles, problems);
    if (forest.trees.size() > maxTrees)
        add(problems, "tree", "more than " + std::to_string(maxTrees) + " trees in all");
    for (std::size_t i = 0; i < forest.species.size() && problems.size() < maxProblems; ++i)
        addPartProblems(check(forest.species[i]), "species", i, problems);
    for (std::size_t i = 0; i < forest.trees.size() && problems.size() < maxProblems; ++i)
        addPartProblems(check(forest.trees[i], forest), "tree", i, problems);
    if (problems.size() > maxProblems)
        problems.resize(maxProblems);
    return problems;
}

} // namespace osgTreeWind
