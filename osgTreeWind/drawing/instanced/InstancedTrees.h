// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/CullLists.h>
#include <osgTreeWind/drawing/instanced/DetailBudget.h>
#include <osgTreeWind/drawing/instanced/InstancedResources.h>
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>
#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/gpu/EntryGuard.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// The trees of a forest under the law `modal`, as instances: no node, drawable or state set a tree. A part
/// of a Forest.
///
/// Each cull chooses what its camera sees of them and how finely; the draws that it hands on are made of
/// lists. osgUtil::IntersectionVisitor meets each tree that it may hit as a TreeHit.
class InstancedTrees : public osg::Drawable {
public:
    /// No trees.
    InstancedTrees();
    explicit InstancedTrees(const std::shared_ptr<ForestSimulation>& simulation);
    /// Drawn from the same models and state as another one of the same models and species.
    InstancedTrees(std::shared_ptr<ForestSimulation> simulation, InstancedResources resources);
    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return "InstancedTrees"; }

    /// A tree was added, moved, changed or removed. In update.
    void treeChanged(std::size_t tree);
    /// A species was added. In update.
    void speciesAdded();
    /// The forest's season is another one. In update.
    void seasonChanged();
    /// Has a tree followed closely from now on, whoever sees it; or no more. In update.
    void keepNear(std::size_t tree, bool kept);
    /// After each step: which trees are followed how closely. In update.
    void update(unsigned frame, double time);

    /// What its trees are drawn from. Changed between frames.
    InstancedResources& resources() { return _resources; }
    const InstancedResources& resources() const { return _resources; }
    /// Trees that are followed closely, since a camera saw their branches of late.
    std::size_t nearTrees() const { return _near.size(); }
    /// Trees in lists of the culls of the last frame, of all cameras, by tier; one that crosses over counts
    /// twice.
    std::array<std::size_t, tierCount> listedTrees() const;

    using osg::Drawable::accept;
    void accept(osg::NodeVisitor& visitor) override;
    /// The trees at rest, from the foot of the lowest; exact for trees that head north or south.
    osg::BoundingBox computeBoundingBox() const override;
    /// The trees as far as they may sway, as culling takes them.
    osg::BoundingBox reach() const { return _cells.bounds(); }
    void drawImplementation(osg::RenderInfo&) const override {}
    /// Whatever its trees are drawn with, as osgUtil::GLObjectsVisitor and pagers ask for it.
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;
    void resizeGLObjectBuffers(unsigned maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~InstancedTrees() override = default;

private:
    void addPasses();
    void shadeNeighbours(std::uint32_t tree);
    void updateFlutter(double time);
    void follow(std::uint32_t tree);
    void cull(osgUtil::CullVisitor& visitor);
    osg::ref_ptr<CullLists> freeLists(const osgUtil::CullVisitor& visitor);
    float detailOf(osgUtil::CullVisitor& visitor, unsigned frame);

    EntryGuard _guard;
    std::shared_ptr<ForestSimulation> _simulation;
    InstancedResources _resources;
    std::vector<osg::ref_ptr<PosePass>> _passes; ///< By model.
    TreeTiers _tiers;
    mutable TreeCells _cells;
    NeighbourShade _shade;
    std::vector<osg::Vec3> _flutter; ///< By species, phases of now.

    struct Attention {
        std::uint8_t seen =
            0; ///< Last bits of the frame in which it last was seen from near, or came to be followed.
        bool isNear = false; ///< Whether it is among those followed closely,
        bool kept = false;   ///< whoever sees it.
    };
    std::vector<Attention> _attention; ///< By tree.
    std::vector<std::uint32_t> _near;  ///< Trees followed closely.
    unsigned _frame = 0;               ///< Of the last update.
    std::atomic<unsigned> _culledFrame{~0u};

    mutable std::mutex _listsMutex; ///< Guards what follows.
    struct Lists {
        const osgUtil::CullVisitor* visitor; ///< Whose they are.
        osg::ref_ptr<CullLists> lists;
    };
    std::vector<Lists> _lists;
    struct View {
        const osg::Camera* camera;
        DetailBudget budget;
        unsigned frame; ///< In which it was seen last.
    };
    std::vector<View> _views; ///< Where there is a budget.
};

} // namespace osgTreeWind
