// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePage.h>

#include <osg/ref_ptr>

#include <cstdint>
#include <mutex>
#include <vector>

namespace osgTreeWind {

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
