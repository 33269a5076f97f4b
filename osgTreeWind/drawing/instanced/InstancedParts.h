// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>

namespace osgTreeWind {

/// What an InstancedForest is made of: for the library's own files and its tests.
struct InstancedParts {
    /// The one drawable of all trees.
    static InstancedTrees* trees(const InstancedForest& forest) { return forest._trees.get(); }
};

} // namespace osgTreeWind
