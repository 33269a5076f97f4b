// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PosePage.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {
namespace {

std::size_t blocksOf(std::size_t units) {
    return std::max<std::size_t>((units + PosePage::blockUnits - 1) / PosePage::blockUnits, 1);
}

} // namespace

/// The entry of a tree in this frame, or the unused entry for it.
PosePlaces::Entry& PosePlaces::findEntry(unsigned frame, std::uint32_t tree) {
    if (frame != _frame) {
        _frame = frame;
        _trees = 0;
        _freePages.insert(_freePages.end(), _pages.begin(), _pages.end());
        _pages.clear();
    }
    if (_entries.size() < 2 * (_trees + 1)) {
        std::vector<Entry> before(std::max<std::size_t>(2 * _entries.size(), 64));
        before.swap(_entries);
        for (const Entry& kept : before)
            if (kept.frame == frame)
                findEntry(frame, kept.tree) = kept;
    }
    const std::size_t mask = _entries.size() - 1;
    std::size_t at = (tree * 2654435761u >> 7u) & mask;
    while (_entries[at].frame == frame && _entries[at].tree != tree)
        at = (at + 1) & mask;
    return _entries[at];
}

void PosePlaces::addPage() {
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
    fresh->blocks.clear();
    fresh->generation = ++_generation;
    _pages.push_back(fresh);
    _pageTrees = _pageBlocks = 0;
}

PosePlaces::Place PosePlaces::addBlocks(std::size_t units) {
    const std::size_t added = blocksOf(units);
    if (_pages.empty() || _pageTrees == PosePage::maxTrees || _pageBlocks + added > PosePage::maxBlocks)
        addPage();
    const Place place{_pages.back(), static_cast<std::uint32_t>(_pageBlocks)};
    ++_trees;
    ++_pageTrees;
    _pageBlocks += added;
    return place;
}

PoseRequest& PosePlaces::addRequest(const Place& place, std::size_t units) {
    PosePage& page = *place.page;
    for (std::size_t block = 0; block < blocksOf(units); ++block)
        page.blocks.push_back(
            {static_cast<float>(page.requests.size()), static_cast<float>(block * PosePage::blockUnits), {}});
    return page.requests.emplace_back();
}

} // namespace osgTreeWind
