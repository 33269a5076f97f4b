// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalModel.h>

namespace osgTreeWind {

/// Transfers sway from one tree to another when a tree is replaced: a least-squares fit that moves the
/// patches of the new tree as those of the old one.
class SwayTransfer {
public:
    /// @param fromLength, toLength lengths of each tree over those of its model.
    SwayTransfer(const ModalModel& from, float fromLength, const ModalModel& to, float toLength);

    /// Modal amplitudes or speeds of the new tree, from those of the old one.
    std::vector<float> transfer(const float* amplitudes) const;
    /// For each patch of the new tree, the nearest patch of the old one, in relative height.
    const std::vector<std::size_t>& patches() const { return _patches; }

private:
    std::size_t _oldModeCount; ///< Number of modes of the old tree.
    std::vector<std::size_t> _patches;
    std::vector<double> _matrix; ///< Matrix from old to new amplitudes, column-major.
};

} // namespace osgTreeWind
