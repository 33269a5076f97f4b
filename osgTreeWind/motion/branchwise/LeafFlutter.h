// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Span.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <glm/vec4.hpp>

namespace osgTreeWind {

/// The leaf law of the thesis (appendix D) for a forest: a state per leaf cluster, tree after tree.
class LeafFlutter {
public:
    /// At rest. @param forest must outlive it. @param wanted whether there are to be any.
    explicit LeafFlutter(const PlacedForest& forest, bool wanted = true);

    /// Back to rest.
    void reset();
    /// One step. Does not allocate.
    void step(double time);
    /// Takes over states computed elsewhere, at least one per cluster.
    void setStates(const std::vector<glm::vec4>& states);

    /// (motionAngleX, motionAngleZ, totalRotaAngle, noise), in the leaf's own frame.
    const std::vector<glm::vec4>& states() const { return _states; }
    Span<glm::vec4> statesOf(const PlacedTree& tree) const {
        if (_states.empty())
            return {};
        return {_states.data() + tree.firstLeaf, _forest.leavesOf(tree)};
    }

private:
    const PlacedForest& _forest;
    std::vector<glm::vec4> _states;
};

} // namespace osgTreeWind
