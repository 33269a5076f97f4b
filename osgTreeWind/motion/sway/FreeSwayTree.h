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

/// A forest of one tree at the origin, with heading 0.
PlacedForest makeSingleTreeForest(const Species& species, const TreePlacement& tree);

/// A single tree under the law `modal` in calm, with an archetype of its own.
class FreeSwayTree {
public:
    FreeSwayTree(const Species& species, const TreePlacement& tree);

    const std::vector<ModalModel::Mode>& modes() const { return _motion.archetype(0).model(0).modes; }
    /// Angular frequency of a mode, including the effect of weight, rad/s.
    double omega(std::size_t mode) const;
    /// Height of the top of the trunk, metres.
    double trunkHeight() const { return static_cast<double>(_rest[_top].z); }
    /// Index of the last unit of the trunk.
    std::size_t topUnit() const { return _top; }

    void setAmplitudes(const std::vector<float>& amplitudes) { _motion.setAmplitudes(0, amplitudes); }
    float amplitude(std::size_t mode) const { return _motion.amplitudes(0)[mode]; }
    void step(double seconds);

    /// Displacement of the tip of each unit from rest, metres.
    std::vector<glm::vec3> tipDisplacements();
    /// Tip displacements per amplitude of each mode, for small amplitudes; by mode and unit. Leaves the tree
    /// at rest.
    std::vector<std::vector<glm::vec3>> tipDisplacementsByMode();

    /// Lets the pulled tree sway freely until `followed` has made six half-swings, which give the frequency.
    /// The damping ratio is that of the mode's amplitude.
    /// @return empty if the half-swings of `followed` or of the mode take more than ten minutes.
    std::optional<FreeSway> measureFreeSway(std::size_t mode, const std::function<double()>& followed);

private:
    PlacedForest _forest;
    ModalMotion _motion;
    std::vector<glm::vec3> _rest; ///< Tips of the units at rest.
    std::size_t _top = 0;
    double _time = 0.0;
};

} // namespace osgTreeWind
