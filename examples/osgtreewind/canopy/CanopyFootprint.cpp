// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFootprint.h>

#include <algorithm>

namespace osgTreeWind {

CanopyFootprint::CanopyFootprint(const CanopyGrid& grid, const TreeBox& box) : foot(box.low.z) {
    for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t most = grid.cells[axis];
        first[axis] = static_cast<int>(std::clamp<std::int64_t>(grid.index(axis, box.low[axis]), 0, most));
        last[axis] =
            static_cast<int>(std::clamp<std::int64_t>(grid.index(axis, box.high[axis]), -1, most - 1));
    }
}

double CanopyFootprint::lowestGround(const CanopyGrid& grid, const Ground* ground) const {
    double lowest = foot;
    if (ground)
        for (int row = first.y; row <= last.y; ++row)
            for (int column = first.x; column <= last.x; ++column)
                lowest = std::min(lowest, grid.groundOf(column, row, ground, foot));
    return lowest;
}

} // namespace osgTreeWind
