// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BillboardCache.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

class BranchwiseForest;
class ForestAnglePasses;

/// The trees of one simulation under a branchwise law: a TreeNode for each tree, and the textures from which
/// shaders pose trees that are drawn without transforms.
class BranchwiseTrees : public osg::Group {
public:
    explicit BranchwiseTrees(std::shared_ptr<ForestSimulation> simulation);

    /// In the order of the trees in the description.
    const std::vector<osg::ref_ptr<TreeNode>>& nodes() const { return _nodes; }
    const TreeBuffers& buffers(std::size_t model) const { return *_buffers[model]; }

    /// Sets colours, shares of leaves and billboards for the season of the simulation.
    void showSeason();
    /// @param texture leaf angles written by the angle passes; null for the leaf angles of the CPU.
    void useLeafAngles(osg::Texture2D* texture);
    /// Copies the leaf angles of the simulation to their texture.
    void uploadLeafAngles();
    /// Poses the trees as in the simulation. @param moved whether they moved since the last call.
    void updatePoses(bool moved);

    void resizeGLObjectBuffers(unsigned maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~BranchwiseTrees() override = default;

private:
    void uploadUnitPoses();

    std::shared_ptr<ForestSimulation> _simulation;
    std::vector<osg::ref_ptr<TreeBuffers>> _buffers; ///< By model.
    std::vector<TreeStyle> _styles;                  ///< By species.
    BillboardCache _billboards;
    std::vector<osg::ref_ptr<TreeNode>> _nodes;
    DataTexture _unitPoses, _leafAngles;
};

/// The nodes of a technique; new ones after its setSimulation().
BranchwiseTrees& branchwiseTrees(const BranchwiseForest& forest);
/// Its running passes; null with CPU_ANGLES.
const ForestAnglePasses* anglePasses(const BranchwiseForest& forest);

} // namespace osgTreeWind
