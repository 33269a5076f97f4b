// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/FrontToBackQueue.h>
#include <osgTreeWind/drawing/instanced/InstancedDraw.h>
#include <osgTreeWind/drawing/instanced/MeshParts.h>
#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>

#include <osg/observer_ptr>
#include <osgUtil/RenderStage>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// The result of one camera's cull of a forest: lists of visible trees and their draws. Drawn as a stage
/// before those draws, it computes the poses that they need, unless another camera of the same frame and
/// context has done so, and writes the lighting of the scene into their state.
///
/// OSG's render stages keep it alive until drawing has finished. It is reused after that, without allocation
/// once its lists are large enough.
class CullLists : public osgUtil::RenderStage {
public:
    CullLists();

    /// The properties that the trees of one list share.
    struct Kind {
        std::size_t band = 0, model = 0;
        Tier tier = Tier::Full; ///< Full for all tiers with branches.
        bool small = false;     ///< Impostors only: whether the trees are too small for a visible bend.
    };
    struct List : Kind {
        DrawnPoses poses;
        std::vector<DrawCommand> barkCommands, leafCommands;
        std::vector<TreeInstance> trees; ///< Those drawn as impostors, or with the geometry of a host.
        std::uint32_t firstInstance = 0; ///< Of `trees`, in buffer().
        osg::ref_ptr<InstancedDraw> bark = new InstancedDraw; ///< The whole tree for impostors.
        osg::ref_ptr<InstancedDraw> leaves = new InstancedDraw;

        /// Adds a part of a tree to the commands.
        void draw(const MeshPart& part, bool isLeaf, std::uint32_t instance);
    };

    /// Empties the lists for a new cull.
    /// @param models number of models in the forest.
    /// @param stage in which the trees are drawn. @param stateGraph of the forest, from which the lighting of
    /// the scene is read.
    void begin(unsigned frame, std::size_t models, osgUtil::RenderStage* stage,
               osgUtil::StateGraph* stateGraph, osg::Camera* camera);
    unsigned frame() const { return _frame; }

    /// Number of distance bands. They are drawn from near to far, so that near trees hide far ones.
    static constexpr std::size_t bands = 4;
    /// The band of a distance in metres: the first one ends at 8 m, each later one at four times the
    /// distance.
    static std::size_t bandOf(float distance);

    /// The list to add trees of this kind to, until the next call. Trees with poses also share a pose page.
    List& list(const Kind& kind, const DrawnPoses& poses = {});
    /// Instances and commands of all lists.
    DrawBuffer& buffer() { return *_buffer; }
    /// Counts a tree that is drawn at a tier.
    void countTree(Tier tier) { ++_treesByTier[static_cast<std::size_t>(tier)]; }

    struct VisibleCell {
        float distance;
        const TreeCells::Cell* cell;
        ViewFrustum::Side side;
    };
    /// A tree that is drawn with branches.
    struct DrawnTree {
        std::size_t model;
        std::uint32_t instance; ///< Index into buffer().
        DrawnPoses poses;
    };
    // Scratch memory of InstancedCull.
    std::vector<DrawnTree>& drawnTrees() { return _drawnTrees; }
    std::vector<VisibleCell>& visibleCells() { return _visibleCells; }
    FrontToBackQueue& frontToBack() { return _frontToBack; }

    /// Slots of the visible trees that need the full motion, for the next update.
    std::vector<std::uint32_t>& nearTrees() { return _nearTrees; }

    std::size_t size() const { return _used; }
    List& operator[](std::size_t index) { return _lists[index]; }

    /// Defines for the lighting of the scene, set before the trees are drawn.
    osg::StateSet* shading() const { return _shading.get(); }
    /// An empty state set for each band; it makes OSG draw the bands in order.
    osg::StateSet* bandState(std::size_t band) const { return _bandStates[band].get(); }

    const std::array<std::size_t, tierCount>& treesByTier() const { return _treesByTier; }

    void draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*& previous) override;
    void reset() override {}
    void releaseGLObjects(osg::State* state = nullptr) const override;

private:
    unsigned _frame = ~0u;
    std::size_t _used = 0, _models = 0;
    osgUtil::RenderStage* _stage = nullptr; // it owns this one while it draws
    osg::ref_ptr<osgUtil::StateGraph> _stateGraph;
    osg::observer_ptr<osg::Camera> _camera; // a ref_ptr could form a cycle: the camera may own the trees
    osg::ref_ptr<osg::StateSet> _shading = new osg::StateSet;
    std::array<osg::ref_ptr<osg::StateSet>, bands> _bandStates;
    std::vector<VisibleCell> _visibleCells;
    std::vector<DrawnTree> _drawnTrees;
    FrontToBackQueue _frontToBack;
    osg::ref_ptr<DrawBuffer> _buffer = new DrawBuffer;
    std::array<std::size_t, tierCount> _treesByTier{};
    std::vector<List> _lists;
    std::vector<std::size_t> _currentLists; ///< By kind: 1 + index of the list being filled; 0 for no list.
    std::vector<std::uint32_t> _nearTrees;
};

} // namespace osgTreeWind
