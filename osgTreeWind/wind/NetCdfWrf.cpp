// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/NetCdfFile.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

namespace {

constexpr float gravity = 9.81f; // as WRF has it

/// Sizes of the mass grid: times, layers, rows, columns.
struct Sizes {
    std::size_t t, z, y, x;
};

/// The mean of neighbours along one staggered axis of an array of blocks of (size + 1) * stride numbers.
std::vector<float> destaggered(const std::vector<float>& values, std::size_t blocks, std::size_t size,
                               std::size_t stride) {
    std::vector<float> means;
    means.reserve(blocks * size * stride);
    for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t i = 0; i < size * stride; ++i) {
            const std::size_t at = block * (size + 1) * stride + i;
            means.push_back(0.5f * (values[at] + values[at + stride]));
        }
    return means;
}

} // namespace

Result<WindContent> readNetCdfWrf(NetCdfFile& file) {
    NetCdfFile::Array arrays[5];
    const char* names[5] = {"U", "V", "W", "PH", "PHB"};
    for (int i = 0; i < 5; ++i) {
        arrays[i] = file.array(names[i]);
        if (!arrays[i] || arrays[i]->GetDimensionCount() != 4) {
            file.fail(names[i], "expected this array of 4 dimensions in WRF output");
            return file.problem();
        }
    }
    const auto& u = arrays[0]->GetDimensions();
    const Sizes n{static_cast<std::size_t>(u[0]->GetSize()), static_cast<std::size_t>(u[1]->GetSize()),
                  static_cast<std::size_t>(u[2]->GetSize()), static_cast<std::size_t>(u[3]->GetSize()) - 1};
    if (n.t < 1 || n.z < 1 || n.y < 1 || u[3]->GetSize() < 2 || u[2]->GetSize() > 100000 ||
        u[3]->GetSize() > 100000)
        file.fail("U", "expected at least one point in each direction, and 100000 at most");

    WindContent content;
    GridWind::Grid grid;
    const double layer = static_cast<double>(n.y) * static_cast<double>(n.x), t = static_cast<double>(n.t),
                 z = static_cast<double>(n.z);
    const double dx = file.positive("DX"), dy = file.positive("DY");
    content.summary.unit = file.speedUnitOf({arrays[0], arrays[1], arrays[2]});
    const std::vector<float> east =
        file.read(arrays[0], t * z * static_cast<double>(n.y) * static_cast<double>(n.x + 1));
    const std::vector<float> north =
        file.read(arrays[1], t * z * static_cast<double>(n.y + 1) * static_cast<double>(n.x));
    const std::vector<float> up = file.read(arrays[2], t * (z + 1.0) * layer);
    std::vector<float> heights = file.read(arrays[3], t * (z + 1.0) * layer);
    const std::vector<float> base = file.read(arrays[4], t * (z + 1.0) * layer);
    const auto times = file.array("XTIME");
    if (times)
        grid.times = file.seconds(times, content.summary.start);
    if (!times || (file.good() && grid.times.size() != n.t))
        file.fail("XTIME", "expected " + std::to_string(n.t) + " times");
    if (!file.good())
        return file.problem();

    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (heights[i] + base[i]) / gravity;
    const std::vector<float> uMean = destaggered(east, n.t * n.z * n.y, n.x, 1),
                             vMean = destaggered(north, n.t * n.z, n.y, n.x),
                             wMean = destaggered(up, n.t, n.z, n.y * n.x);
    grid.heights = destaggered(heights, n.t, n.z, n.y * n.x);
    grid.points = {static_cast<int>(n.x), static_cast<int>(n.y), static_cast<int>(n.z)};
    grid.cell = {dx, dy, 1.0};
    grid.values.reserve(3 * uMean.size());
    for (std::size_t i = 0; i < uMean.size(); ++i)
        grid.values.insert(grid.values.end(), {uMean[i], vMean[i], wMean[i]});
    content.summary.format = "NetCDF, WRF output";
    content.summary.direction = "components toward x, y and up of the model's grid";
    content.summary.notes = {"velocities at cell centres, means of the staggered neighbours",
                             "x and y are metres from the centre of the south-western cell",
                             "heights are (PH + PHB) / 9.81, metres above sea level, of each point and time"};
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind
