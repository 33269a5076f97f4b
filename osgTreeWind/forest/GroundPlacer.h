// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// Places trees on a forest's ground, in batches. A foot is at the lowest ground within the trunk.
class GroundPlacer {
public:
    /// @param forest must have a ground and outlive this object. Its trees and tiles determine its shapes.
    explicit GroundPlacer(const ForestDescription& forest) : _ground(*forest.ground), _families(forest) {}

    /// @param indices of the trees to place. Trees without ground below them keep their position.
    void place(std::vector<TreePlacement>& trees, const std::vector<std::size_t>& indices);
    /// A problem with the number of trees so far that have no ground below them, and the first of them.
    Diagnostics problems() const;

private:
    double trunkRadius(const TreePlacement& tree);
    /// Why there is no ground at a place.
    std::string reasonAt(const glm::dvec2& place) const;

    const Ground& _ground;
    ShapeFamilies _families;
    std::map<std::pair<std::size_t, std::uint32_t>, TreeSize> _shapeSizes; ///< By family and shape.
    std::size_t _trees = 0, _groundless = 0;
    std::string _firstGroundless; ///< Its name and the reason.
};

} // namespace osgTreeWind
