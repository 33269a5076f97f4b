// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Ends of the levels of detail of a tree: distances from the eye to its middle, in heights of the tree; may
/// be infinite.
struct TreeLodRanges {
    float full = 8.0f; ///< End of the level with transforms for branches and leaf clusters.
    /// End of the level with the same leaves and bark, but no transforms. Farther trees are billboards.
    float leaves = 20.0f;
};

} // namespace osgTreeWind
