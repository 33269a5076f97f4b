// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/CullLists.h>
#include <osgTreeWind/nodes/SceneShading.h>
#include <osgTreeWind/nodes/SpeciesLooks.h>
#include <osgTreeWind/nodes/StandShape.h>
#include <osgTreeWind/nodes/TreeCells.h>
#include <osgTreeWind/nodes/ViewFrustum.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// The trees of a forest under the law `modal`, as instances: no node, drawable or state set a tree. A part of a
/// Forest.
///
/// Each cull chooses what its camera sees of them and how finely; the draws that it hands on are made of lists.
class TreeStand : public osg::Drawable {
public:
    TreeStand() = default;
    explicit TreeStand(std::shared_ptr<ForestSimulation> simulation);
    /// Of the same trees, which the original's forest moves; shares what it is drawn from.
    TreeStand(const TreeStand& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeStand)

        /// A tree was added, moved, changed or removed. In update.
        void treeChanged(std::size_t tree);
    /// After each step: which trees are followed how closely. In update.
    void update(unsigned frame, double time);

    SpeciesLooks& looks(std::size_t species) { return _looks[species]; }
    StandShape& shape(std::size_t model) { return *_shapes[model]; }

    /// Trees that some camera has seen with branches of late.
    std::size_t nearTrees() const { return _near.size(); }

    void accept(osg::NodeVisitor& visitor) override;
    osg::BoundingBox computeBoundingBox() const override;
    void drawImplementation(osg::RenderInfo&) const override {}
    void resizeGLObjectBuffers(unsigned maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~TreeStand() override = default;

private:
    using osg::Drawable::accept;
    class Cull;
    struct Camera;
    Camera& cameraOf(osgUtil::CullVisitor& visitor);
    void cull(osgUtil::CullVisitor& visitor);

    std::shared_ptr<ForestSimulation> _simulation;
    std::vector<osg::ref_ptr<StandShape>> _shapes; ///< By model.
    std::vector<SpeciesLooks> _looks;              ///< By species.
    std::vector<osg::Vec3> _flutter;               ///< By species, phases of now.
    osg::ref_ptr<osg::StateSet> _state;
    osg::ref_ptr<osg::Program> _impostorProgram;
    std::shared_ptr<TreeTiers> _tiers;
    std::shared_ptr<SceneShading> _shading;
    mutable TreeCells _cells;

    std::vector<std::uint8_t> _seen; ///< By tree, frame (its last bits) in which it last had branches; 0: never.
    std::vector<std::uint32_t> _near; ///< Trees followed closely.
    std::atomic<unsigned> _culledFrame{~0u};

    std::mutex _cameraMutex; ///< Guards the map; each camera is culled by one thread at a time.
    std::map<const osgUtil::CullVisitor*, std::unique_ptr<Camera>> _cameras;
};

} // namespace osgTreeWind
