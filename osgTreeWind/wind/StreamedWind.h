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

/// A grid that a simulation fills with new velocities, and may move, while others sample it.
///
/// Any number of threads may update and sample at once: an update becomes the wind by swapping a pointer, and
/// every sample() sees it whole or not at all.
///
///     auto wind = StreamedWind::create(grid).value();
///     forest->setWind(wind);
///     report(wind->update({velocities})); // in every frame, from any thread
class OSGTREEWIND_EXPORT StreamedWind final : public WindField {
public:
    /// What a simulation says anew. Nothing of it is needed after update().
    struct Update {
        Span<float> velocities; ///< u, v, w of each point, m/s, ordered as in GridWind::Grid.
        /// Where the grid's first point now stands, metres; empty: where it stood. Its heights, where it has
        /// any, rise and sink with it.
        std::optional<glm::dvec3> origin = std::nullopt;
        /// Simulation time in seconds at which the velocities hold; empty: from now on, at all times.
        ///
        /// Between the last two updates with times the wind is linear in time; before the one it is held, and
        /// after the other. So a host that updates for a time a little ahead gives trees a steady wind, and
        /// one that is late a wind that stands still until it comes.
        std::optional<double> time = std::nullopt;
    };

    /// A field that starts with the grid's values, or what is wrong with the grid. It has one time at most:
    /// that at which they hold.
    static Result<std::shared_ptr<StreamedWind>> create(GridWind::Grid grid);

    /// Makes this the wind. A wrong number of velocities, a number that is not finite and a time that is not
    /// after that of the update before are problems, and the wind stays as it was.
    /// @return the problems; empty when all is well.
    Diagnostics update(const Update& update);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    using GridPtr = std::shared_ptr<const GridWind>;
    /// The last one, or two with times.
    struct Updates {
        std::vector<GridPtr> grids;
        std::vector<double> times; ///< Of each; empty where the one holds at all times.
    };

    StreamedWind(GridWind::Grid shape, Updates&& first);
    std::shared_ptr<const Updates> current() const { return std::atomic_load(&_updates); }

    const GridWind::Grid _shape; ///< As create() was given it, without values.
    std::mutex _updating;
    std::shared_ptr<const Updates> _updates; ///< Only through std::atomic_load and std::atomic_store.
};

} // namespace osgTreeWind
