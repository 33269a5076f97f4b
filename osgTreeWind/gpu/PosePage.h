// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/TreeFall.h>

#include <osg/Referenced>
#include <osg/ref_ptr>

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

/// Assigns rows in the pose pages of a frame to trees of one model. All requests for a tree in a frame get
/// the same row. Any thread.
class PoseRows {
public:
    /// @param pageTrees maximum number of trees per page.
    explicit PoseRows(std::size_t pageTrees) : _pageTrees(pageTrees) {}

    struct Row {
        PosePage* page;
        int row;
    };
    /// @param tree a number that identifies the tree.
    /// @param fill called with a PoseRequest& at the first request for the tree in a frame.
    template <typename Fill>
    Row row(unsigned frame, std::uint32_t tree, const Fill& fill) {
        const std::lock_guard<std::mutex> lock(_mutex);
        bool isNew = false;
        const Row row = findOrAddRow(frame, tree, isNew);
        if (isNew) {
            const std::lock_guard<std::mutex> pageLock(row.page->mutex());
            fill(row.page->requests.emplace_back());
        }
        return row;
    }

private:
    struct Entry {
        std::uint32_t tree = 0, frame = ~0u, place = 0;
    };

    Row findOrAddRow(unsigned frame, std::uint32_t tree, bool& isNew);
    Entry& findEntry(std::uint32_t tree);
    void addPage();

    const std::size_t _pageTrees;
    std::mutex _mutex; ///< Guards the members below; locked before the mutex of a page.
    unsigned _frame = ~0u;
    std::uint64_t _generation = 0; ///< Of the last page.
    std::uint32_t _rowCount = 0;
    std::vector<Entry> _entries; ///< A hash table, a power of two long.
    std::vector<osg::ref_ptr<PosePage>> _pages, _freePages;
};

} // namespace osgTreeWind
