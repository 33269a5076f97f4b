// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

namespace osgTreeWind {

/// A forest of one tree, which stands at the origin and is not turned.
PlacedForest loneTree(const Species& species, const TreePlacement& tree);

/// The first tree of a forest under the law `modal`, as if it stood at the origin and were not turned.
ModalTree swayingTree(const PlacedForest& forest);

} // namespace osgTreeWind
