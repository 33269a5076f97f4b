// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/GrowingSpaces.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/io/TreeBounds.h>
#include <osgTreeWind/io/TreeSpool.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The first place of an inventory, and the place with its longitude and latitude exchanged.
struct ExchangedPlace {
    glm::dvec2 place, exchanged;
    std::string advice; ///< How to exchange them.
};

/// Trees of an inventory that has heights of feet.
struct InventoryHeights {
    std::string file;
    std::size_t begin = 0, end = 0; ///< Among all trees.
    bool isAssumed = false;         ///< Whether no key says that the z of places is the height of feet.
};

/// The trees that are read from a document.
class DocumentTrees {
public:
    /// @param memory holds trees that are in memory; must outlive this object.
    explicit DocumentTrees(TreeSpool::Trees& memory) : _spool(memory) {}

    std::size_t maxCount = 1000000; ///< More trees are an error.

    /// The trees so far, for ForestStream.
    TreeSpool& spool() { return _spool; }
    std::size_t size() const { return _spool.size(); }
    const TreeBounds& bounds() const { return _bounds; }

    /// Whether `count` more trees are allowed; otherwise reports a problem with `key`.
    bool canAdd(std::uint64_t count, TableReader& table, const std::string& key) const;
    /// Reserves a name. @return false if it is taken.
    bool reserveName(const std::string& name) { return _names.insert(name).second; }
    /// Appends a tree. @param onGround as in TreeSpool::add().
    void add(const TreePlacement& tree, bool onGround, DerivedTreeValues derived);

    /// As TreeSpool::visit() and modify().
    void visit(const std::function<void(const TreeSpool::Trees& trees)>& visitor) {
        _spool.visit([&](const TreeSpool::Trees& trees, const std::vector<std::size_t>&) { visitor(trees); });
    }
    /// Visits the trees of an inventory whose feet have heights.
    void visitFeet(const InventoryHeights& heights,
                   const std::function<void(const TreePlacement& tree)>& visitor);
    void modify(const std::function<void(TreeSpool::Trees& trees, const std::vector<std::size_t>& onGround)>&
                    modifier);
    std::vector<InventoryHeights> inventoryHeights;
    /// Places in the CRS of the scene.
    std::vector<ExchangedPlace> exchangedPlaces;
    /// "; " and the advice for an inventory of which only the exchanged place is in an area; otherwise empty.
    std::string adviceToExchange(const std::function<bool(const glm::dvec2& place)>& isInArea) const;
    // If the trees are in memory, which is that of the forest:
    void findGrowingSpaces(ForestDescription& forest);
    void varyNeighbourSeeds(ForestDescription& forest, const ShapeFamilies& families);
    /// Ends the reading: releases memory.
    void forgetNames() { _names.clear(); }

private:
    TreeSpool _spool;
    TreeBounds _bounds;
    std::vector<DerivedTreeValues> _derived; ///< By tree, if they are in memory.
    std::set<std::string> _names;
};

/// Values of trees that do not set them.
struct TreeDefaults {
    std::uint32_t seed = 1; ///< Of the document.
    float leaves = 1.0f;    ///< TreePlacement::leaves.
};

} // namespace osgTreeWind
