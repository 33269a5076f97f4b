// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TextureCapacity.h>

#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/model/TreeModel.h>

#include <algorithm>
#include <vector>

namespace osgTreeWind {

std::string textureCapacityProblem(const ForestDescription& description) {
    if (description.law == MotionLaw::Modal)
        return {};
    const ShapeFamilies families(description);
    std::vector<std::size_t> units, leaves;
    for (const TreeCounts& counts : families.countLargest()) {
        units.push_back(counts.units);
        leaves.push_back(counts.leafVertices / verticesPerLeafCluster);
    }
    std::size_t branchTexels = 0, leafTexels = 0;
    for (const TreePlacement& tree : description.trees) {
        branchTexels += 3 * units[families.indexOf(tree)]; // branch parameters are the largest
        leafTexels += leaves[families.indexOf(tree)];
    }
    if (std::max(branchTexels, leafTexels) <= DataTexture::maxTexels)
        return {};
    const bool branches = branchTexels > leafTexels;
    return std::to_string(description.trees.size()) + " trees under a branchwise law need " +
           std::to_string(std::max(branchTexels, leafTexels)) + " texels of " +
           (branches ? "branch parameters" : "leaf angles") + "; a texture holds " +
           std::to_string(DataTexture::maxTexels) + ". The law modal has no such limit";
}

} // namespace osgTreeWind
