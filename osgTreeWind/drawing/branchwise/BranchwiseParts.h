// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/gpu/branchwise/AnglePrePass.h>

namespace osgTreeWind {

/// What a BranchwiseForest is made of: for the library's own files and its tests.
struct BranchwiseParts {
    /// In the order that the trees were given in; unchecked.
    static TreeNode* tree(const BranchwiseForest& forest, unsigned index) {
        return forest._trees->nodes()[index].get();
    }
    /// Of a model.
    static const TreeBuffers& buffers(const BranchwiseForest& forest, std::size_t model) {
        return forest._trees->buffers(model);
    }
    /// The passes at work; null with CPU_ANGLES.
    static const AnglePrePass* prePass(const BranchwiseForest& forest) { return forest._prePass.get(); }
};

} // namespace osgTreeWind
