// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/gpu/branchwise/ForestAnglePasses.h>

namespace osgTreeWind {

/// Access to the parts of a BranchwiseForest for the library and its tests.
struct BranchwiseParts {
    /// @param index in the order of the description, not checked.
    static TreeNode* tree(const BranchwiseForest& forest, unsigned index) {
        return forest._trees->nodes()[index].get();
    }
    static const TreeBuffers& buffers(const BranchwiseForest& forest, std::size_t model) {
        return forest._trees->buffers(model);
    }
    /// The running passes; null with CPU_ANGLES.
    static const ForestAnglePasses* prePass(const BranchwiseForest& forest) { return forest._prePass.get(); }
};

} // namespace osgTreeWind
