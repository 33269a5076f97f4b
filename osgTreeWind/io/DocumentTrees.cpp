// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/DocumentTrees.h>

namespace osgTreeWind {

bool DocumentTrees::canAdd(std::uint64_t count, TableReader& table, const std::string& key) const {
    if (count <= maxCount && size() + count <= maxCount)
        return true;
    table.problem(key, "more than " + std::to_string(maxCount) + " trees in all");
    return false;
}

void DocumentTrees::add(const TreePlacement& tree, bool onGround, DerivedTreeValues derived) {
    _bounds.add(tree);
    _spool.add(tree, onGround);
    if (_spool.isInMemory())
        _derived.push_back(derived);
}

void DocumentTrees::modify(
    const std::function<void(TreeSpool::Trees& trees, const std::vector<std::size_t>& onGround)>& modifier) {
    _bounds = {};
    _spool.modify([&](TreeSpool::Trees& trees, const std::vector<std::size_t>& onGround) {
        modifier(trees, onGround);
        _bounds.add(trees);
    });
}

std::string
DocumentTrees::adviceToExchange(const std::function<bool(const glm::dvec2& place)>& isInArea) const {
    for (const ExchangedPlace& each : exchangedPlaces)
        if (isInArea(each.exchanged) && !isInArea(each.place))
            return "; " + each.advice;
    return {};
}

void DocumentTrees::findGrowingSpaces(ForestDescription& forest) {
    if (!_spool.isInMemory())
        return;
    osgTreeWind::findGrowingSpaces(forest, _derived);
    _bounds = {};
    _bounds.add(forest.trees);
}

void DocumentTrees::varyNeighbourSeeds(ForestDescription& forest, const ShapeFamilies& families) {
    if (_spool.isInMemory())
        osgTreeWind::varyNeighbourSeeds(forest, families, _derived);
}

} // namespace osgTreeWind
