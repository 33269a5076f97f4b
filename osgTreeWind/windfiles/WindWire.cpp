// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindWire.h>

#include <osgTreeWind/base/Wire.h>

namespace osgTreeWind {

namespace {

bool passWind(Wire& wire, WindContent& content) {
    WindSummary& summary = content.summary;
    auto& grid = std::get<GridWind::Grid>(content.data);
    unsigned char aboveGround = grid.aboveGround ? 1 : 0;
    const bool good = wire.pass(summary.format) && wire.pass(summary.unit) && wire.pass(summary.direction) &&
                      wire.pass(summary.coordinates) && wire.pass(summary.crs) && wire.pass(summary.start) &&
                      wire.pass(summary.notes) && wire.pass(grid.points) && wire.pass(grid.origin) &&
                      wire.pass(grid.cell) && wire.pass(grid.times) && wire.pass(grid.heights) &&
                      wire.pass(aboveGround) && wire.pass(grid.values);
    grid.aboveGround = aboveGround != 0;
    return good;
}

} // namespace

bool WindWire::send(int descriptor, Result<WindContent>& content) {
    return Wire::send(descriptor, content, passWind);
}

std::optional<Result<WindContent>> WindWire::receive(int descriptor) {
    return Wire::receive(descriptor, passWind);
}

} // namespace osgTreeWind
