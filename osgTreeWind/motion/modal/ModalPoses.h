// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/TreeMotion.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

namespace osgTreeWind {

/// Poses of the units of a tree, all of them in place, for a ModalMotion::poseVector().
std::vector<UnitPose> modalPoses(const PlacedForest& forest, std::size_t slot, const ModalMotion& modal,
                                 const ModalMotion::PoseVector& vector);

/// The poses of trees under the law `modal`, computed on request. Different threads may ask for different
/// trees, as long as nothing changes the trees.
struct ModalPoses {
    const PlacedForest& forest;
    const ModalMotion& modal; ///< Its trees have the numbers of the forest's slots.
    double time;              ///< Seconds.
    bool withLeaves;          ///< Whether leaves flutter.

    /// Present state of a tree, computed into `values`; empty if the slot is.
    TreeMotion motion(std::size_t slot, UnitValues& values) const;
    /// One unit of motion(), for the cost of its ancestor units. @param slot must hold a tree.
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const;

private:
    void pull(std::size_t slot, UnitValues& values) const;
    void flutter(const PlacedTree& tree, UnitValues& values) const;
};

} // namespace osgTreeWind
