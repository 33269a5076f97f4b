// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/TreeFall.h>

#include <osg/Referenced>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// Input of the pose passes for one tree: a row of the texture `poseRequests` (shaders/pose_request.glsl).
struct PoseRequest {
    static constexpr std::size_t maxPatches = Archetype::details[0].patches,
                                 maxColumns = Archetype::details[0].modes + 3 * maxPatches,
                                 texels = 3 + maxColumns / 4 + maxPatches + TreeFall::maxParts;

    float firstTexel = -1.0f;             ///< Of the archetype's matrix in PosePass; negative: at rest.
    float rowTexels = 0.0f;               ///< Texels per row of that matrix.
    float maxAngle = 0.0f;                ///< ModalModel::maxAngle.
    float streamlining = 0.0f;            ///< Reconfiguration::streamlining.
    float across = 1.0f, upward = 1.0f;   ///< TreeScale::axes.
    float streamlinedTo = 25.0f;          ///< Reconfiguration::streamlinedTo.
    float maxPull = 0.0f;                 ///< Reconfiguration::maxPull.
    float vector[maxColumns] = {};        ///< Modal amplitudes, forces on the patches, zeros.
    float patchWinds[maxPatches][4] = {}; ///< In the tree's axes, m/s; the fourth value is 0.
    float breezeStreamlining = 0.0f;      ///< Reconfiguration::breezeStreamlining.
    float unused[3] = {};
    /// TreeFall::parts, each as turn, unit and 0; zeros for no part.
    std::array<std::array<float, 4>, TreeFall::maxParts> fallen{};
};
static_assert(sizeof(PoseRequest) == PoseRequest::texels * 4 * sizeof(float));

/// Size of the rectangle that the units of a tree occupy in textures of poses (shaders/pose_request.glsl).
struct PoseLayout {
    explicit PoseLayout(std::size_t units)
        : width(static_cast<int>(std::clamp<std::size_t>(units, 1, 2048))),
          rows(static_cast<int>((std::max<std::size_t>(units, 1) - 1) / static_cast<std::size_t>(width)) +
               1) {}
    int width; ///< Units per row.
    int rows;  ///< Rows per tree.
};

/// Trees of one model that are drawn in a frame, as many as fit into one texture of poses. Cull traversals of
/// several cameras fill it, under its lock; draws hold references to it.
class PosePage : public osg::Referenced {
public:
    std::mutex& mutex() const { return _mutex; }
    std::vector<PoseRequest> requests; ///< By row.
    std::uint64_t generation = 0;      ///< Differs each time the page is cleared for another frame.

private:
    mutable std::mutex _mutex;
};

} // namespace osgTreeWind
