// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

struct ImpostorPictures;

/// Mean coverage over all azimuths of an impostor's pictures, on a coarse grid inside the margins.
class ImpostorCoverage {
public:
    static constexpr int side = 8; ///< Rows and columns of the grid.
    using Grid = std::array<float, side * side>;

    explicit ImpostorCoverage(const ImpostorPictures& pictures);

    const Grid& grid(int elevation) const { return _grids[static_cast<std::size_t>(elevation)]; }

private:
    std::vector<Grid> _grids; ///< By elevation.
};

} // namespace osgTreeWind
