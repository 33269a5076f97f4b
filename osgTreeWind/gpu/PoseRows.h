// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePage.h>

#include <osg/ref_ptr>

#include <cstdint>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// Hands out rows of a frame's pages to those who draw trees of one model: the same one for all who ask for a
/// tree. Any thread.
class PoseRows {
public:
    /// @param pageTrees the most on a page.
    explicit PoseRows(std::size_t pageTrees) : _pageTrees(pageTrees) {}

    struct Row {
        PosePage* page;
        int row;
    };
    /// `fill`, given a PoseRequest&, is called for the first who asks in a frame.
    /// @param tree any number that stands for it.
    template <typename Fill>
    Row row(unsigned frame, std::uint32_t tree, const Fill& fill) {
        const std::lock_guard<std::mutex> lock(_mutex);
        bool isNew = false;
        const Row row = rowOf(frame, tree, isNew);
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

    Row rowOf(unsigned frame, std::uint32_t tree, bool& isNew);
    Entry& entry(std::uint32_t tree);
    void addPage();

    const std::size_t _pageTrees;
    std::mutex _mutex; ///< Guards all below; locked before that of a page.
    unsigned _frame = ~0u;
    std::uint64_t _fillings = 0; ///< Of pages.
    std::uint32_t _asked = 0;
    std::vector<Entry> _entries; ///< A hash table, a power of two long.
    std::vector<osg::ref_ptr<PosePage>> _pages, _spare;
};

} // namespace osgTreeWind
