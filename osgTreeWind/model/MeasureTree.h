// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>

namespace osgTreeWind {

/// Size of a model at a scale with all parts above 0, including wood and leaves.
TreeSize measureTree(const TreeExtents& extents, const TreeScale& scale = {});
TreeSize measureTree(const TreeModel& model, const TreeScale& scale = {});

/// Cross-section of the trunk at breast height, m^2.
float trunkSection(const Skeleton& skeleton, const TreeScale& scale = {});

/// The scale at which measureTree() gives `size`, within 1 % if the shape allows it: no crown is narrower
/// than its trunk. Sizes that are not given follow the height in proportion; without any size, the scale
/// is 1.
TreeScale fitTree(const TreeExtents& extents, const TreeSize& size);
TreeScale fitTree(const TreeModel& model, const TreeSize& size);

} // namespace osgTreeWind
