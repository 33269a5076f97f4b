// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/Span.h>
#include <osgTreeWind/wind/GridWind.h>

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// A grid of wind that a running simulation updates, and may move, while the forest samples it.
///
/// Any number of threads may update and sample at the same time. Updates are atomic: every sample() sees
/// either all or nothing of an update.
///
///     auto wind = StreamedWind::create(grid).value();
///     report(forest->setWind(wind));
///     report(wind->update({velocities})); // in every frame, from any thread
class OSGTREEWIND_EXPORT StreamedWind final : public WindField {
public:
    /// New data from the simulation.
    struct Update {
        /// u, v, w of each point, m/s, in the order of GridWind::Grid::values. Refers to your memory, which
        /// must exist until update() has returned.
        Span<float> velocities;
        /// New position of the grid's first point, metres; empty: unchanged. Layer heights move with it.
        std::optional<glm::dvec3> origin = std::nullopt;
        /// Simulation time of the velocities, seconds; empty: they replace the wind at all times.
        ///
        /// The wind is linear in time between the last two updates with a time, and clamped to them before
        /// and after. Send updates slightly ahead of time for a continuous wind; until a late update arrives,
        /// the wind does not change.
        std::optional<double> time = std::nullopt;
    };

    /// Checks the grid and returns a wind that starts with its values, or the problems. @param grid with at
    /// most one time, that of its values.
    static Result<std::shared_ptr<StreamedWind>> create(GridWind::Grid grid);

    /// Replaces the wind. A wrong number of velocities, a value that is not finite, or a time that is not
    /// after that of the previous update is a problem, and the wind does not change.
    /// @return the problems; empty on success.
    [[nodiscard]] Diagnostics update(const Update& update);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    using GridPtr = std::shared_ptr<const GridWind>;
    /// The latest update, or the latest two with times.
    struct Updates {
        std::vector<GridPtr> grids;
        std::vector<double> times; ///< One for each grid; empty if the only grid holds at all times.
    };

    StreamedWind(GridWind::Grid shape, Updates&& first);
    std::shared_ptr<const Updates> current() const;

    const GridWind::Grid _shape; ///< As given to create(), without values.
    std::mutex _updating;
    std::shared_ptr<const Updates> _updates; ///< Access only with std::atomic_load and std::atomic_store.
};

} // namespace osgTreeWind
