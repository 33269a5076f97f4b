// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>

namespace osgTreeWind {

/// Access to the parts of an InstancedForest for the library and its tests.
struct InstancedParts {
    /// The drawable of all trees.
    static InstancedTrees* trees(const InstancedForest& forest) { return forest._trees.get(); }
};

} // namespace osgTreeWind
