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

/// Puts trees on a forest's ground, some at a time: each grows upright, its foot at the lowest point of the
/// trunk's circle.
class FeetOnGround {
public:
    /// @param forest with a ground, which outlives this. Its trees, or its tiles, say how its species stand.
    explicit FeetOnGround(const ForestDescription& forest) : _ground(*forest.ground), _families(forest) {}

    /// @param which of them; those without ground below them stay where they are.
    void put(std::vector<TreePlacement>& trees, const std::vector<std::size_t>& which);
    /// One where some of all trees so far have no ground below them: how many, and which first.
    Diagnostics problems() const;

private:
    double trunkRadius(const TreePlacement& tree);

    const Ground& _ground;
    ShapeFamilies _families;
    std::map<std::pair<std::size_t, std::uint32_t>, TreeSize> _natural; ///< By family and shape.
    std::size_t _trees = 0, _groundless = 0;
    std::string _first;
};

} // namespace osgTreeWind
