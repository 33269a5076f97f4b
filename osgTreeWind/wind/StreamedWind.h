// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/GridWind.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// A grid that a simulation fills with new velocities while others sample it.
///
/// update() may be called from any thread, once at a time, beside any number of threads that sample: the new
/// array becomes the wind by swapping a pointer, and every sample() sees one array from beginning to end.
class OSGTREEWIND_EXPORT StreamedWind final : public WindField {
public:
    /// A field that starts with the grid's values, or what is wrong with the grid. It has one time at most.
    static Result<std::shared_ptr<StreamedWind>> create(GridWind::Grid grid);

    /// Makes these velocities the wind from now on; ordered as in GridWind::Grid. A wrong number of values,
    /// or one that is not finite, is a problem, and the wind stays as it was.
    /// @return the problems; empty when all is well.
    Diagnostics update(std::vector<float> values);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    using GridPtr = std::shared_ptr<const GridWind>;

    explicit StreamedWind(GridPtr grid);
    GridPtr current() const { return std::atomic_load(&_grid); }

    GridPtr _grid; ///< Only through std::atomic_load and std::atomic_store.
};

} // namespace osgTreeWind
