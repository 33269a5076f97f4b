// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/FrontToBackQueue.h>
#include <osgTreeWind/drawing/instanced/InstancedDraw.h>
#include <osgTreeWind/drawing/instanced/LeafOrders.h>
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
        Tier tier = Tier::Full;
        bool fading = false;   ///< Whether the trees fade to another tier.
        bool small = false;    ///< Impostors only: whether the trees are too small for a visible bend.
        std::size_t order = 0; ///< Index into LeafOrders; 0 for impostors.
    };
    struct List : Kind {
        osg::ref_ptr<InstanceList> trees = new InstanceList;
        osg::ref_ptr<InstancedDraw> bark = new InstancedDraw; ///< The whole tree for impostors.
        osg::ref_ptr<InstancedDraw> leaves = new InstancedDraw;
    };

    /// Empties the lists for a new cull.
    /// @param models number of models in the forest.
    /// @param stage in which the trees are drawn. @param stateGraph of the forest, from which the lighting of
    /// the scene is read.
    void begin(unsigned frame, std::size_t models, osgUtil::RenderStage* stage,
               osgUtil::StateGraph* stateGraph, osg::Camera* camera);
    unsigned frame() const { return _frame; }

    /// Number of distance bands. They are drawn from near to far, so that near trees hide far ones.
    static constexpr std::size_t bands = 6;
    /// The band of a distance in metres: the first one ends at 60 m, each later one is twice as deep.
    static std::size_t bandOf(float distance);

    /// The list to add trees of this kind to. Trees with poses also share a pose page.
    InstanceList& list(const Kind& kind, const PosePass* passes = nullptr, PosePage* page = nullptr);

    struct VisibleCell {
        float distance;
        const TreeCells::Cell* cell;
        ViewFrustum::Side side;
    };
    // Scratch memory of InstancedCull.
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

    /// Adds the number of trees in all lists to the counts by tier.
    void addTreeCounts(std::array<std::size_t, tierCount>& trees) const;

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
    FrontToBackQueue _frontToBack;
    std::vector<List> _lists;
    std::vector<std::size_t> _currentLists; ///< By kind: 1 + index of the list being filled; 0 for no list.
    std::vector<std::uint32_t> _nearTrees;
};

} // namespace osgTreeWind
