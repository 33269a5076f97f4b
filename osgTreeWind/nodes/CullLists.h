// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/InstancedDraw.h>
#include <osgTreeWind/nodes/PoseStage.h>
#include <osgTreeWind/nodes/TreeTiers.h>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// What one cull visitor has seen of a stand in a frame: lists of trees, and the draws and passes they take. Kept from
/// frame to frame, so that nothing is allocated once they are long enough.
class CullLists {
public:
    struct List {
        std::size_t shape = 0;
        Tier tier = Tier::Full;
        osg::ref_ptr<InstanceList> trees = new InstanceList;
        osg::ref_ptr<InstancedDraw> bark = new InstancedDraw; ///< Of impostors the whole.
        osg::ref_ptr<InstancedDraw> leaves = new InstancedDraw;
    };

    /// A cull of one camera begins. @param frame what earlier culls of it left is kept for their draws.
    void begin(unsigned frame, std::size_t shapes);
    unsigned frame() const { return _frame; }

    /// The list that trees of this shape and tier go to, and of this page if they have poses.
    InstanceList& list(std::size_t shape, Tier tier, const PosePass* passes, PosePage* page);

    /// Trees that were seen from near, though they are followed from afar; for the next update.
    std::vector<std::uint32_t>& awoken() { return _awoken; }

    /// Those of the cull at hand.
    std::size_t first() const { return _first; }
    std::size_t end() const { return _used; }
    List& operator[](std::size_t index) { return _lists[index]; }

    /// For the camera of the cull at hand. @param place PoseStage::begin().
    PoseStage* stage(osgUtil::StateGraph* place);

    /// Adds the trees in all lists of the frame.
    void countTrees(std::array<std::size_t, tierCount>& trees) const;
    void releaseGLObjects(osg::State* state) const;

private:
    unsigned _frame = ~0u;
    std::size_t _first = 0, _used = 0, _stagesUsed = 0;
    std::vector<List> _lists;
    std::vector<std::size_t> _open; ///< By shape and tier, the list that is filled now; 0: none, else one more.
    std::vector<osg::ref_ptr<PoseStage>> _stages;
    std::vector<std::uint32_t> _awoken;
};

} // namespace osgTreeWind
