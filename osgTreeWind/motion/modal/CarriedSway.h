// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalModel.h>

namespace osgTreeWind {

/// What moves the patches of another tree as nearly as its modes can as those of a tree move: the sway of a
/// tree that becomes another one.
class CarriedSway {
public:
    /// @param fromLength, toLength lengths of either tree over those of its model.
    CarriedSway(const ModalModel& from, float fromLength, const ModalModel& to, float toLength);

    /// Amplitudes of the other tree's modes, or their speeds, from those of the tree's.
    std::vector<float> carried(const float* amplitudes) const;
    /// Per patch of the other tree, that of the tree which is nearest, for its height.
    const std::vector<std::size_t>& patches() const { return _patches; }

private:
    const ModalModel& _from;
    const ModalModel& _to;
    double _length; ///< Of the tree over that of the other.
    std::vector<std::size_t> _patches;
    std::vector<std::vector<double>> _factor; ///< Of Cholesky, of V^T V of the other tree, lower triangle.
};

} // namespace osgTreeWind
