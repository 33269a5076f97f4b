// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeCells.h>

#include <cmath>

namespace osgTreeWind {

osg::BoundingBox TreeCells::swayBox(const Tree& tree) {
    const float aside = tree.reach + sway * tree.height;
    return {tree.foot - osg::Vec3(aside, aside, aside * 0.25f),
            tree.foot + osg::Vec3(aside, aside, (1.0f + rise) * tree.height)};
}

std::uint32_t TreeCells::cellAt(const osg::Vec3& foot) {
    const auto column = static_cast<std::int32_t>(std::floor(foot.x() / side));
    const auto row = static_cast<std::int32_t>(std::floor(foot.y() / side));
    const std::uint64_t ground =
        std::uint64_t(static_cast<std::uint32_t>(column)) << 32u | static_cast<std::uint32_t>(row);
    const auto [found, isNew] =
        _cellByPosition.try_emplace(ground, static_cast<std::uint32_t>(_cells.size()));
    if (isNew)
        _cells.emplace_back();
    return found->second;
}

void TreeCells::insert(const Tree& tree) {
    if (tree.slot >= _places.size())
        _places.resize(tree.slot + 1u);
    remove(tree.slot);
    const std::uint32_t index = cellAt(tree.foot);
    Cell& cell = _cells[index];
    _places[tree.slot] = {index, static_cast<std::uint32_t>(cell.trees.size())};
    cell.trees.push_back(tree);
    cell.box.expandBy(swayBox(tree));
}

void TreeCells::remove(std::uint32_t slot) {
    if (slot >= _places.size() || _places[slot].cell == ~0u)
        return;
    Cell& cell = _cells[_places[slot].cell];
    const std::uint32_t index = _places[slot].index;
    cell.trees[index] = cell.trees.back();
    _places[cell.trees[index].slot].index = index;
    cell.trees.pop_back();
    cell.stale = true;
    _places[slot] = {};
}

osg::BoundingBox TreeCells::bounds() {
    osg::BoundingBox all;
    for (Cell& cell : _cells) {
        if (cell.stale) {
            cell.box.init();
            for (const Tree& tree : cell.trees)
                cell.box.expandBy(swayBox(tree));
            cell.stale = false;
        }
        all.expandBy(cell.box);
    }
    return all;
}

} // namespace osgTreeWind
