// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

struct ImpostorPictures;

/// Which share of what is behind a tree its pictures hide: means over all azimuths, on a coarse grid over the
/// inside of a picture, row by row from below.
class PictureCover {
public:
    static constexpr int side = 8; ///< Of the grid.
    using Grid = std::array<float, side * side>;

    explicit PictureCover(const ImpostorPictures& pictures);

    const Grid& grid(int elevation) const { return _grids[static_cast<std::size_t>(elevation)]; }

private:
    std::vector<Grid> _grids; ///< By elevation, as the pictures.
};

} // namespace osgTreeWind
