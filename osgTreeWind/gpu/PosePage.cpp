// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PosePage.h>

#include <utility>

namespace osgTreeWind {

/// The entry of a tree in this frame, or the unused entry for it.
PoseRows::Entry& PoseRows::findEntry(std::uint32_t tree) {
    if (_entries.size() < 2 * (_rowCount + 1)) {
        std::vector<Entry> before(std::max<std::size_t>(2 * _entries.size(), 64));
        before.swap(_entries);
        for (const Entry& kept : before)
            if (kept.frame == _frame)
                findEntry(kept.tree) = kept;
    }
    const std::size_t mask = _entries.size() - 1;
    std::size_t at = (tree * 2654435761u >> 7u) & mask;
    while (_entries[at].frame == _frame && _entries[at].tree != tree)
        at = (at + 1) & mask;
    return _entries[at];
}

void PoseRows::addPage() {
    osg::ref_ptr<PosePage> fresh;
    for (osg::ref_ptr<PosePage>& page : _freePages)
        if (page->referenceCount() == 1) { // no draw refers to it any more
            std::swap(page, _freePages.back());
            fresh = _freePages.back();
            _freePages.pop_back();
            break;
        }
    if (!fresh)
        fresh = new PosePage;
    fresh->requests.clear();
    fresh->generation = ++_generation;
    _pages.push_back(fresh);
}

PoseRows::Row PoseRows::findOrAddRow(unsigned frame, std::uint32_t tree, bool& isNew) {
    if (frame != _frame) {
        _frame = frame;
        _rowCount = 0;
        _freePages.insert(_freePages.end(), _pages.begin(), _pages.end());
        _pages.clear();
    }
    Entry& known = findEntry(tree);
    isNew = known.frame != frame;
    if (isNew) {
        known.tree = tree;
        known.frame = frame;
        known.place = _rowCount++;
        if (known.place % _pageTrees == 0)
            addPage();
    }
    return {_pages[known.place / _pageTrees], static_cast<int>(known.place % _pageTrees)};
}

} // namespace osgTreeWind
