// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Up to which distance a tree is drawn how, in heights of the tree; infinity: however far.
struct TreeLodRanges {
    float full = 8.0f;    ///< Up to here all of a tree is drawn,
    float leaves = 20.0f; ///< and up to here its leaves.
};

} // namespace osgTreeWind
