// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <array>
#include <random>
#include <vector>

namespace osgTreeWind {

/// Streaks that show the path of air particles in the last second, in the undisturbed wind, among and above
/// the trees. Their colours are lighter than those of WindArrows.
class WindStreaks : public SceneGeometry {
public:
    static constexpr unsigned count = 900;

    WindStreaks();

    /// Moves the particles to a time. Between frames.
    /// @param middle centre of the square. @param reach half its side; both in the forest's frame, metres.
    void show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach);

protected:
    ~WindStreaks() override = default;

private:
    static constexpr unsigned points = 8; ///< Per streak.
    struct Streak {
        std::array<glm::vec3, points> trail; ///< Newest point first.
        float life = 0.0f;                   ///< Remaining time, seconds.
    };

    void restart(Streak& streak, const ForestDescription& forest, const glm::vec2& middle, float reach,
                 float highest);
    float randomUnit() {
        return static_cast<float>(_random() - _random.min()) / static_cast<float>(_random.max());
    }

    std::vector<Streak> _streaks{count};
    std::minstd_rand _random;
    double _time = 0.0, _lastTrailTime = 0.0; ///< Of the last call, and of the last trail points; seconds.
    bool _hasStarted = false;
};

} // namespace osgTreeWind
