// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CheckForest.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/model/TreeFields.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/species/SpeciesFields.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

constexpr std::size_t mostProblems = 100;

void add(Diagnostics& problems, const std::string& key, const std::string& message) {
    problems.push_back(keyProblem(key, message));
}

/// What is out of range, or else does not go together.
template <typename Struct>
void checkWhole(const Struct& value, const std::string& path, Diagnostics& problems) {
    const std::size_t before = problems.size();
    checkFields(value, path, problems);
    if (problems.size() == before)
        for (const FieldConflict& conflict : conflictsOf(value))
            add(problems, path + (conflict.key.empty() ? "" : '.' + conflict.key), conflict.message);
}

void checkSpecies(const Species& species, const std::string& path, Diagnostics& problems) {
    if (species.name.empty())
        add(problems, path + ".name", "missing");
    checkFields(species, path, problems);
    checkWhole(species.tree.wood, path + ".tree", problems);
    if (species.tree.grown)
        checkWhole(*species.tree.grown, path + ".growth", problems);
    checkFields(species.tree.leaves, path + ".leaves", problems);
}

void checkTree(TreePlacement tree, const ForestDescription& forest, const std::string& path,
               Diagnostics& problems) {
    if (tree.species >= forest.species.size())
        add(problems, path + ".species", "no species " + std::to_string(tree.species));
    for (int axis = 0; axis < 3; ++axis)
        if (!worldCoordinates.contains(tree.position[axis]))
            add(problems, path + ".position",
                "expected a finite number " + worldCoordinates.text() + ", found " +
                    numberText(tree.position[axis]));
    if (glm::distance(tree.position, forest.origin) > farthestTree)
        add(problems, path + ".position", "more than 100 km from the origin");
    for (float* size : {&tree.size.height, &tree.size.trunkDiameter, &tree.size.crownWidth})
        if (!(*size > 0.0f))
            *size = 1.0f; // not given
    checkFields(tree, path, problems);
}

} // namespace

Diagnostics check(const ForestDescription& forest) {
    Diagnostics problems;
    if (!forest.crs.empty())
        if (const auto crs = Crs::parseMap(forest.crs); !crs)
            problems.push_back(crs.problems().front());
    checkFields(forest, "motion", problems);
    if (!frameSteps.contains(forest.step))
        add(problems, "step", "expected a finite number " + frameSteps.text());
    if (forest.damage && forest.law != MotionLaw::Modal)
        add(problems, "motion.damage", "expected false under any law but \"modal\"");
    if (forest.noiseExponent && !noiseExponents.contains(static_cast<double>(*forest.noiseExponent)))
        add(problems, "motion.noise_exponent", "expected a finite number " + noiseExponents.text());
    checkWhole(forest.drawing, "drawing", problems);
    if (!seasons.contains(static_cast<double>(forest.season)))
        add(problems, "season", "expected a finite number " + seasons.text());
    for (int axis = 0; axis < 3; ++axis)
        if (!Range().contains(forest.origin[axis]))
            add(problems, "origin", "expected finite numbers");
    if (forest.trees.size() > mostTrees)
        add(problems, "tree", "more than " + std::to_string(mostTrees) + " trees in all");
    for (std::size_t i = 0; i < forest.species.size() && problems.size() < mostProblems; ++i)
        checkSpecies(forest.species[i], "species[" + std::to_string(i) + ']', problems);
    for (std::size_t i = 0; i < forest.trees.size() && problems.size() < mostProblems; ++i)
        checkTree(forest.trees[i], forest, "tree[" + std::to_string(i) + ']', problems);
    if (problems.size() > mostProblems)
        problems.resize(mostProblems);
    return problems;
}

} // namespace osgTreeWind
