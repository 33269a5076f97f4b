// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>

namespace osgTreeWind {

/// Size of a model under a scale whose parts are above 0: that of all its wood and leaves.
TreeSize measureTree(const TreeExtents& extents, const TreeScale& scale = {});
TreeSize measureTree(const TreeModel& model, const TreeScale& scale = {});

/// Cross-section of the trunk at breast height, m^2.
float trunkSection(const Skeleton& skeleton, const TreeScale& scale = {});

/// The scale under which measureTree() gives `size` (within 1 %) as far as the shape can have it: no crown is
/// narrower than its trunk. Sizes not given follow the height in proportion; with no size at all the scale
/// is 1.
TreeScale fitTree(const TreeExtents& extents, const TreeSize& size);
TreeScale fitTree(const TreeModel& model, const TreeSize& size);

} // namespace osgTreeWind
