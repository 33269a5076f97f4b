// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BillboardPictures.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// The trees of one simulation under a law of a branch: a TreeNode each, and the textures from which shaders
/// pose those that are drawn without transforms.
class BranchwiseTrees : public osg::Group {
public:
    explicit BranchwiseTrees(std::shared_ptr<ForestSimulation> simulation);

    /// In the order that the trees were given in.
    const std::vector<osg::ref_ptr<TreeNode>>& nodes() const { return _nodes; }
    /// Of a model.
    const TreeBuffers& buffers(std::size_t model) const { return *_buffers[model]; }

    /// Colours, leaves and pictures of the simulation's season.
    void showSeason();
    /// @param texture of leaf angles that passes write; null: those of the CPU.
    void useLeafAngles(osg::Texture2D* texture);
    /// Takes the leaf angles of the simulation over into the texture.
    void uploadLeafAngles();
    /// Has the trees stand as the simulation has them now. @param moved whether they did since the last call.
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
    BillboardPictures _pictures;
    std::vector<osg::ref_ptr<TreeNode>> _nodes;
    DataTexture _unitPoses, _leafAngles;
};

} // namespace osgTreeWind
