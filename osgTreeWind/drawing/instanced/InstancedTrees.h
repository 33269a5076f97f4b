// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/CullLists.h>
#include <osgTreeWind/drawing/instanced/DetailBudget.h>
#include <osgTreeWind/drawing/instanced/InstancedCull.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace osgTreeWind {

class InstancedForest;

/// The drawable of all trees of a forest under the law `modal`. Trees are instances, without a node, drawable
/// or state set for each. A part of a Forest.
///
/// Each cull selects the trees that its camera sees and their tiers, and adds instanced draws to the render
/// bin. An osgUtil::IntersectionVisitor receives each tree that it may hit as a TreeHit.
class InstancedTrees : public osg::Drawable {
public:
    InstancedTrees();
    explicit InstancedTrees(const std::shared_ptr<ForestSimulation>& simulation);
    /// Shares the resources of a forest with the same models and species.
    InstancedTrees(std::shared_ptr<ForestSimulation> simulation, InstancedResources resources);
    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return "InstancedTrees"; }

    // In update; trees are given by their slot in the simulation.

    /// Call it after a tree was added, moved, changed or removed.
    void treeChanged(std::size_t tree);
    /// Call it after a species was added.
    void speciesAdded();
    /// Call it after the season changed.
    void seasonChanged();
    /// Keeps a tree at ModalMotion::Level::Near even if no camera sees it, or stops doing so.
    void keepNear(std::size_t tree, bool pinned);
    /// Updates the motion levels of the trees. Call it after each step.
    void update(unsigned frame, double time);

    /// May be changed between frames.
    InstancedResources& resources() { return _scene.resources; }
    const InstancedResources& resources() const { return _scene.resources; }
    /// Number of trees at ModalMotion::Level::Near: those whose branches a camera saw in the last frames.
    std::size_t nearTreeCount() const { return _nearTrees.size(); }
    /// Number of trees that all cameras drew in the last culled frame, by tier. A tree that fades between two
    /// tiers counts in both.
    std::array<std::size_t, tierCount> treesByTier() const;

    /// For comparison: whether to draw parts of trees that others hide.
    void setDrawsHiddenParts(bool draws) { _scene.drawsHiddenParts = draws; }

    using osg::Drawable::accept;
    void accept(osg::NodeVisitor& visitor) override;
    /// Bounds of the trees at rest. They are tight for headings that are multiples of a right angle.
    osg::BoundingBox computeBoundingBox() const override;
    /// A conservative bound that includes the sway, used for culling.
    osg::BoundingBox swayBounds() const { return _scene.cells.bounds(); }
    void drawImplementation(osg::RenderInfo&) const override {}
    /// Compiles all resources for osgUtil::GLObjectsVisitor and database pagers.
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;
    void resizeGLObjectBuffers(unsigned maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~InstancedTrees() override = default;

private:
    void addModels();
    void updateShade(std::uint32_t tree);
    void updateFlutter(double time);
    void markNear(std::uint32_t tree);
    void promoteSeenTrees();
    void demoteUnseenTrees();
    void forgetViews();
    void cull(osgUtil::CullVisitor& visitor);
    osg::ref_ptr<CullLists> acquireLists(const osgUtil::CullVisitor& visitor);
    float detailOf(osgUtil::CullVisitor& visitor, unsigned frame);

    ExceptionGuard _guard;
    std::shared_ptr<ForestSimulation> _simulation;
    InstancedScene _scene;

    struct NearState {
        std::uint8_t lastSeen = 0; ///< Low bits of the last frame in which a camera saw the branches.
        bool isNear = false;       ///< Whether `_nearTrees` holds the tree.
        bool pinned = false;       ///< Whether keepNear() holds it there.
    };
    std::vector<NearState> _nearStates; ///< By slot.
    std::vector<std::uint32_t> _nearTrees;
    unsigned _frame = 0; ///< Frame of the last update.
    std::atomic<unsigned> _culledFrame{~0u};

    mutable std::mutex _listsMutex; ///< Guards the members below.
    struct VisitorLists {
        const osgUtil::CullVisitor* visitor;
        osg::ref_ptr<CullLists> lists;
    };
    std::vector<VisitorLists> _lists;
    struct View {
        const osg::Camera* camera;
        DetailBudget budget;
        unsigned frame; ///< Frame of the last cull.
    };
    std::vector<View> _views; ///< Empty without a budget.
};

/// The drawable of a technique; a new one after its setSimulation().
InstancedTrees& instancedTrees(const InstancedForest& forest);

} // namespace osgTreeWind
