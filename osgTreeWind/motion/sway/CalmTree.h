// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/UnitPose.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <functional>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// A forest of one tree, which stands at the origin and is not turned.
PlacedForest loneTree(const Species& species, const TreePlacement& tree);

/// One tree under the law `modal`, with modes of its own, in a calm.
class CalmTree {
public:
    CalmTree(const Species& species, const TreePlacement& tree);

    const std::vector<ModalModel::Mode>& modes() const { return _motion.archetype(0).model(0).modes; }
    /// Angular frequency of a mode, lowered by the weight of the tree, rad/s.
    double pace(std::size_t mode) const;
    /// Height of the top of the trunk, metres.
    double trunkHeight() const { return static_cast<double>(_rest[_top].z); }
    /// The last unit of the trunk.
    std::size_t top() const { return _top; }

    void setAmplitudes(const std::vector<float>& amplitudes) { _motion.setAmplitudes(0, amplitudes); }
    float amplitude(std::size_t mode) const { return _motion.amplitudes(0)[mode]; }
    void step(double seconds);

    /// How far the tip of each unit is from where it rests, metres.
    std::vector<glm::vec3> shifts();
    /// The same per unit of a mode's amplitude, for small amplitudes: by mode and unit. Leaves the tree at
    /// rest.
    std::vector<std::vector<glm::vec3>> shiftsByMode();

    /// Steps a tree that was pulled until `followed` has made six half-swings, which give the frequency; the
    /// damping ratio is that of the mode's own amplitude.
    /// @return nothing when the half-swings of `followed` or of the mode take more than ten minutes.
    std::optional<FreeSway> release(std::size_t mode, const std::function<double()>& followed);

private:
    PlacedForest _forest;
    ModalMotion _motion;
    std::vector<glm::vec3> _rest; ///< Tips.
    std::size_t _top = 0;
    double _time = 0.0;
    std::vector<glm::vec2> _angles;
    std::vector<glm::quat> _rotations;
    std::vector<UnitPose> _poses;
};

} // namespace osgTreeWind
