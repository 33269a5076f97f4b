// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/TreeFall.h>

#include <osg/Referenced>
#include <osg/ref_ptr>

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
    float firstUnit = 0.0f;               ///< Of the model, in PosePass.
    float units = 0.0f;                   ///< Of the model.
    float unused = 0.0f;
    /// TreeFall::parts, each as turn, unit and 0; zeros for no part.
    std::array<std::array<float, 4>, TreeFall::maxParts> fallen{};
};
static_assert(sizeof(PoseRequest) == PoseRequest::texels * 4 * sizeof(float));

/// Trees that are drawn in a frame, as many as fit into one texture of poses. A tree occupies whole blocks of
/// consecutive texels, one texel per unit. Cull traversals of several cameras fill the page, under its lock;
/// draws hold references to it.
class PosePage : public osg::Referenced {
public:
    static constexpr std::size_t blockUnits = 64, rowBlocks = DataTexture::width / blockUnits,
                                 maxBlocks = rowBlocks * DataTexture::maxRows, maxTrees = 8192;

    /// A texel of the texture `poseBlocks` (shaders/pose_request.glsl).
    struct Block {
        float request = 0.0f;   ///< Index.
        float firstUnit = 0.0f; ///< Of the block, within the model.
        float unused[2] = {};
    };

    std::mutex& mutex() const { return _mutex; }
    std::vector<PoseRequest> requests;
    std::vector<Block> blocks;
    std::uint64_t generation = 0; ///< Differs each time the page is cleared for another frame.

private:
    mutable std::mutex _mutex;
};

/// Assigns blocks in the pose pages of a frame to trees. All requests for a tree in a frame get the same
/// ones. Any thread.
class PosePlaces {
public:
    struct Place {
        PosePage* page = nullptr;
        std::uint32_t block = 0; ///< The first one.
    };
    /// @param tree a number that identifies the tree. @param units number of its units.
    /// @param fill called with a PoseRequest& at the first request for the tree in a frame.
    template <typename Fill>
    Place place(unsigned frame, std::uint32_t tree, std::size_t units, const Fill& fill) {
        const std::lock_guard<std::mutex> lock(_mutex);
        Entry& entry = findEntry(frame, tree);
        if (entry.frame != frame) {
            entry = {tree, frame, addBlocks(units)};
            const std::lock_guard<std::mutex> pageLock(entry.place.page->mutex());
            fill(addRequest(entry.place, units));
        }
        return entry.place;
    }

private:
    struct Entry {
        std::uint32_t tree = 0;
        unsigned frame = ~0u;
        Place place;
    };

    Entry& findEntry(unsigned frame, std::uint32_t tree);
    Place addBlocks(std::size_t units);
    PoseRequest& addRequest(const Place& place, std::size_t units);
    void addPage();

    std::mutex _mutex; ///< Guards the members below; locked before the mutex of a page.
    unsigned _frame = ~0u;
    std::uint64_t _generation = 0;                           ///< Of the last page.
    std::size_t _trees = 0, _pageTrees = 0, _pageBlocks = 0; ///< Of this frame; of its last page.
    std::vector<Entry> _entries;                             ///< A hash table, a power of two long.
    std::vector<osg::ref_ptr<PosePage>> _pages, _freePages;
};

} // namespace osgTreeWind
