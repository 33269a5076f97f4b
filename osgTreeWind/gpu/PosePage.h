// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/TreeFall.h>

#include <osg/Referenced>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// What the passes need of one tree: a row of the texture `poseRequests` (shaders/pose_request.glsl).
struct PoseRequest {
    static constexpr std::size_t mostColumns = 48, mostPatches = 12, texels = 31;

    float firstTexel = -1.0f; ///< Of its archetype's matrix, as PosePass::ask() has it; negative: at rest.
    float rowTexels = 0.0f;   ///< Of a row of that matrix.
    float maxAngle = 0.0f;
    float streamlining = 0.0f;             ///< Reconfiguration::streamlining,
    float across = 1.0f, upward = 1.0f;    ///< TreeScale::axes
    float streamlinedTo = 25.0f;           ///< streamlinedTo
    float mostPull = 0.0f;                 ///< and mostPull.
    float vector[mostColumns] = {};        ///< Amplitudes, then forces on patches; the rest 0.
    float patchWinds[mostPatches][4] = {}; ///< In the tree's own axes, m/s; 0.
    float breezeStreamlining = 0.0f;       ///< Reconfiguration's.
    float unused[3] = {};
    std::array<std::array<float, 4>, TreeFall::mostParts> fallen{}; ///< TreeFall::parts: turn, unit, 0;
                                                                    ///< 0 for none.
};
static_assert(sizeof(PoseRequest) == PoseRequest::texels * 4 * sizeof(float));

/// How the units of a tree lie in textures of poses (shaders/pose_request.glsl).
struct PoseLayout {
    explicit PoseLayout(std::size_t units)
        : width(static_cast<int>(std::clamp<std::size_t>(units, 1, 2048))),
          rows(static_cast<int>((std::max<std::size_t>(units, 1) - 1) / static_cast<std::size_t>(width)) +
               1) {}
    int width; ///< Units in a row,
    int rows;  ///< and rows of a tree.
};

/// Trees of one model that are drawn in a frame, as many as fit into one texture of poses. Culls of several
/// cameras fill it, under its lock; it is kept by those who draw from it.
class PosePage : public osg::Referenced {
public:
    std::mutex& mutex() const { return _mutex; }
    std::vector<PoseRequest> requests; ///< By row.
    std::uint64_t filling = 0;         ///< Another number each time the page is begun anew.

private:
    mutable std::mutex _mutex;
};

} // namespace osgTreeWind
