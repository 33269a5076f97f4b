// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/FrontToBack.h>
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

/// What one camera's cull has seen of a forest: lists of trees, and the draws that they take. As a stage
/// before those draws it works out the poses they need, which others that draw the same trees in the same
/// frame and context find done, and puts what the scene says of light into their state.
///
/// Whoever may still draw of it refers to it as a stage; then it may be filled again, and nothing is
/// allocated once it is large enough.
class CullLists : public osgUtil::RenderStage {
public:
    CullLists();

    /// What trees of one list have in common.
    struct Kind {
        std::size_t band = 0, model = 0;
        Tier tier = Tier::Full;
        bool fading = false;   ///< Whether they cross over to another tier.
        bool small = false;    ///< Whether their bend is too small to be seen; of impostors.
        std::size_t order = 0; ///< Of LeafOrders; of those with branches.
    };
    struct List : Kind {
        osg::ref_ptr<InstanceList> trees = new InstanceList;
        osg::ref_ptr<InstancedDraw> bark = new InstancedDraw; ///< Of impostors the whole.
        osg::ref_ptr<InstancedDraw> leaves = new InstancedDraw;
    };

    /// A cull by a camera begins, of trees of so many models. @param place of the trees in the scene's
    /// state.
    void begin(unsigned frame, std::size_t models, osgUtil::StateGraph* place, osg::Camera* camera);
    unsigned frame() const { return _frame; }

    /// Trees are drawn band by band, so that near ones hide the far ones behind them.
    static constexpr std::size_t bands = 6;
    /// That of trees in this distance, metres: the first one up to 60 m, each of the others twice as deep.
    static std::size_t bandOf(float distance);

    /// The list that trees of this kind go to, and of this page if they have poses.
    InstanceList& list(const Kind& kind, const PosePass* passes = nullptr, PosePage* page = nullptr);

    struct SeenCell {
        float distance;
        const TreeCells::Cell* cell;
        ViewFrustum::Side side;
    };
    /// Memory for cells that are seen, and for trees in them that may hide others.
    std::vector<SeenCell>& seenCells() { return _seenCells; }
    FrontToBack& frontToBack() { return _frontToBack; }

    /// Trees that are seen from near, for the next update.
    std::vector<std::uint32_t>& near() { return _near; }

    std::size_t size() const { return _used; }
    List& operator[](std::size_t index) { return _lists[index]; }

    /// State of the trees, filled in before they are drawn.
    osg::StateSet* shading() const { return _shading.get(); }
    /// That of a band, which says nothing, and has OSG draw one band after the other.
    osg::StateSet* bandState(std::size_t band) const { return _bandStates[band].get(); }

    /// Adds the trees in all lists.
    void countTrees(std::array<std::size_t, tierCount>& trees) const;

    void draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*& previous) override;
    void reset() override {}
    void releaseGLObjects(osg::State* state = nullptr) const override;

private:
    unsigned _frame = ~0u;
    std::size_t _used = 0, _models = 0;
    osg::ref_ptr<osgUtil::StateGraph> _place;
    osg::observer_ptr<osg::Camera> _camera; // which may hold the trees
    osg::ref_ptr<osg::StateSet> _shading = new osg::StateSet;
    std::array<osg::ref_ptr<osg::StateSet>, bands> _bandStates;
    std::vector<SeenCell> _seenCells;
    FrontToBack _frontToBack;
    std::vector<List> _lists;
    std::vector<std::size_t> _open; ///< By kind, the list that is filled now; 0: none, else one more.
    std::vector<std::uint32_t> _near;
};

} // namespace osgTreeWind
