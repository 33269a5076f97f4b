// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/PlacedForest.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/ReserveGrowth.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace osgTreeWind {

namespace {

bool isSameSize(const TreeSize& a, const TreeSize& b) {
    return a.height == b.height && a.trunkDiameter == b.trunkDiameter && a.crownWidth == b.crownWidth;
}

} // namespace

PlacedForest::PlacedForest(ForestDescription forest, const std::function<void()>& onTree,
                           const Executor& executor)
    : _families(std::make_shared<const ShapeFamilies>(forest)) {
    const std::vector<TreePlacement> placements = std::exchange(forest.trees, {});
    if (forest.tiles)
        _removedPermanently = forest.tiles->removed;
    _description = std::make_shared<const ForestDescription>(std::move(forest));
    growShapes(executor);
    setSeason(description().season);

    trees.reserve(placements.size());
    for (const TreePlacement& placement : placements) {
        PlacedTree tree = makePlacedTree(placement);
        tree.firstUnit = static_cast<std::uint32_t>(units);
        tree.firstLeaf = static_cast<std::uint32_t>(leaves);
        units += unitCount(tree);
        leaves += leafCount(tree);
        put(trees.size(), tree, placement.name);
        if (onTree)
            onTree();
    }
}

/// Grows the shapes of species that have none yet.
void PlacedForest::growShapes(const Executor& executor) {
    const std::size_t first = _models.size();
    std::vector<std::pair<const TreeParameters*, std::uint32_t>> shapes;
    for (std::size_t i = _firstModels.size(); i < _families->all().size(); ++i) {
        const ShapeFamilies::Family& family = _families->all()[i];
        _firstModels.push_back(static_cast<std::uint32_t>(first + shapes.size()));
        for (std::uint32_t shape = 0; shape < family.shapes; ++shape)
            shapes.emplace_back(&family.tree, shape);
    }
    _models.resize(first + shapes.size());
    runJobs(executor ? executor : ThreadPool::executor(), shapes.size(),
            [&](std::size_t i) { _models[first + i] = sharedTreeModel(*shapes[i].first, shapes[i].second); });
    for (std::size_t i = _species.size(); i < description().species.size(); ++i)
        _species.push_back(std::make_shared<const Species>(description().species[i]));
}

std::size_t PlacedForest::addSpecies(Species species, const Executor& executor) {
    const auto families = std::make_shared<ShapeFamilies>(*_families);
    families->add(species, true, true);
    _families = families;
    _seasonLeaves.push_back(leafShare(species.appearance, _season));
    const auto extended = std::make_shared<ForestDescription>(description());
    extended->species.push_back(std::move(species));
    _description = extended;
    growShapes(executor);
    return _species.size() - 1;
}

PlacedTree PlacedForest::makePlacedTree(const TreePlacement& placement, const PlacedTree* previous) const {
    PlacedTree tree;
    tree.species = static_cast<std::uint32_t>(placement.species);
    const Species& species = speciesOf(tree);
    const bool isSized = previous && isSameSize(placement.size, sizeOf(*previous));
    TreePlacement selecting = placement;
    if (isSized)
        selecting.size = previous->givenSize; // the size that selected its shape
    const std::size_t family = _families->indexOf(selecting);
    tree.model = _firstModels[family] + placement.seed % _families->all()[family].shapes;
    const bool isKept = isSized && previous->model == tree.model;
    tree.givenSize = isKept ? previous->givenSize : placement.size;
    tree.estimated = isKept ? previous->estimated : placement.estimated;
    tree.openGrown = isKept ? previous->openGrown : placement.openGrown;
    tree.scale = isKept ? previous->scale
                        : fitTree(modelOf(tree), completeSize(tree.givenSize, species, tree.openGrown));
    tree.atEdge = placement.atEdge;
    tree.tiled = placement.tiled;
    tree.position = glm::vec3(placement.position - description().origin);
    tree.heading = placement.heading;
    tree.summerLeaves = placement.leaves;
    tree.leaves = placement.leaves * _seasonLeaves[tree.species];
    tree.seed = placement.seed;
    return tree;
}

TreePlacement PlacedForest::placementOf(std::size_t slot) const {
    const PlacedTree& tree = trees[slot];
    TreePlacement placement;
    placement.species = tree.species;
    placement.position = glm::dvec3(tree.position) + description().origin;
    placement.heading = tree.heading;
    placement.size = sizeOf(tree);
    placement.leaves = tree.summerLeaves;
    placement.openGrown = tree.openGrown;
    placement.atEdge = tree.atEdge;
    placement.seed = tree.seed;
    placement.name = names.of(static_cast<std::uint32_t>(slot));
    return placement;
}

ForestDescription PlacedForest::currentDescription() const {
    ForestDescription now = description();
    now.season = _season;
    if (now.tiles)
        now.tiles->removed = _removedPermanently;
    for (std::size_t slot = 0; slot < trees.size(); ++slot) {
        if (!trees[slot].alive || trees[slot].tiled)
            continue;
        TreePlacement tree = placementOf(slot);
        tree.size = trees[slot].givenSize;
        tree.estimated = trees[slot].estimated;
        tree.openGrown = trees[slot].openGrown;
        now.trees.push_back(std::move(tree));
    }
    return now;
}

void PlacedForest::setSeason(float season) {
    _season = wrapSeason(season);
    _seasonLeaves.clear();
    for (const Species& species : description().species)
        _seasonLeaves.push_back(leafShare(species.appearance, _season));
    for (PlacedTree& tree : trees)
        tree.leaves = tree.summerLeaves * _seasonLeaves[tree.species];
}

void PlacedForest::put(std::size_t slot, PlacedTree tree, const std::string& name) {
    if (slot == trees.size()) {
        reserveGrowth(trees, slot + 1);
        trees.emplace_back();
    }
    if (!_freeSlots.empty() && _freeSlots.back() == slot)
        _freeSlots.pop_back();
    PlacedTree& old = trees[slot];
    tree.generation = old.generation;
    tree.alive = true;
    old = tree;
    names.set(static_cast<std::uint32_t>(slot), name);
}

void PlacedForest::remove(std::size_t slot) {
    trees[slot].alive = false;
    ++trees[slot].generation;
    _freeSlots.push_back(static_cast<std::uint32_t>(slot));
    names.set(static_cast<std::uint32_t>(slot), {});
}

void PlacedForest::removePermanently(std::size_t slot) {
    if (trees[slot].tiled)
        _removedPermanently.insert(names.of(static_cast<std::uint32_t>(slot)));
}

bool PlacedForest::holds(TreeId id) const {
    const std::size_t slot = slotOfTree(id);
    return slot < trees.size() && trees[slot].alive && idOf(slot) == id;
}

std::size_t PlacedForest::speciesOfModel(std::size_t model) const {
    const auto after = std::upper_bound(_firstModels.begin(), _firstModels.end(), model);
    return _families->all()[static_cast<std::size_t>(after - _firstModels.begin()) - 1].species;
}

glm::vec3 rotateAboutZ(const glm::vec3& v, float sine, float cosine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

} // namespace osgTreeWind
