// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/model/TreeModel.h>

#include <algorithm>

namespace osgTreeWind {

/// What a forester measures, in metres, 0.001 to 1000. A value that is not above 0 means "not given".
struct TreeSize {
    float height = 0.0f;        ///< Ground to the highest point of wood or leaves.
    float trunkDiameter = 0.0f; ///< At breastHeight().
    float crownWidth = 0.0f;    ///< Mean of the east-west and north-south extents.
};

/// Where trunks are measured, of a tree of that height: 1.3 m, or a tenth of the height if that is lower.
inline float breastHeight(float height) {
    return std::min(1.3f, 0.1f * height);
}

/// Which measures of a TreeSize nobody took: they follow from laws of its species.
struct EstimatedSizes {
    bool height = false;        ///< Metres were not given,
    bool trunkDiameter = false; ///< nor these,
    bool crownWidth = false;    ///< nor these.
};

/// How a shared model is stretched to one tree: a rest point p of the centre line becomes axes * p, radii are
/// multiplied by `radius`, leaf clusters by `leaf`.
struct TreeScale {
    glm::vec3 axes{1.0f}; ///< Of positions along x, y and z.
    float radius = 1.0f;  ///< Of radii of wood.
    float leaf = 1.0f;    ///< Of leaf clusters.
};

/// Size of a model under a scale whose parts are above 0: that of all its wood and leaves.
OSGTREEWIND_EXPORT TreeSize measureTree(const TreeExtents& extents, const TreeScale& scale = {});
OSGTREEWIND_EXPORT TreeSize measureTree(const TreeModel& model, const TreeScale& scale = {});

/// Cross-section of the trunk at breast height, m^2.
float trunkSection(const Skeleton& skeleton, const TreeScale& scale = {});

/// The scale under which measureTree() gives `size` (within 1 %) as far as the shape can have it: no crown is
/// narrower than its trunk. Sizes not given follow the height in proportion; with no size at all the scale
/// is 1.
OSGTREEWIND_EXPORT TreeScale fitTree(const TreeExtents& extents, const TreeSize& size);
OSGTREEWIND_EXPORT TreeScale fitTree(const TreeModel& model, const TreeSize& size);

} // namespace osgTreeWind
