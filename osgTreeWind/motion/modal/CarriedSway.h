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
    std::size_t _before; ///< Modes of the tree.
    std::vector<std::size_t> _patches;
    std::vector<double> _carried; ///< Amplitudes of the other tree by each of the tree's.
};

} // namespace osgTreeWind
