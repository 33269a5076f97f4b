// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/DocumentTrees.h>

#include <algorithm>

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

void DocumentTrees::visitFeet(const InventoryHeights& heights,
                              const std::function<void(const TreePlacement& tree)>& visitor) {
    std::size_t first = 0;
    _spool.visit([&](const TreeSpool::Trees& some, const std::vector<std::size_t>& onGround) {
        for (std::size_t i = 0; i < some.size(); ++i)
            if (first + i >= heights.begin && first + i < heights.end &&
                !std::binary_search(onGround.begin(), onGround.end(), i))
                visitor(some[i]);
        first += some.size();
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
