// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>

#include <osg/Geometry>

#include <array>
#include <random>
#include <vector>

namespace osgTreeWind {

/// Streaks of air that travel with the wind, as it is given, between and above the trees: what each has
/// passed in the last second, lighter than the arrows of that wind (WindArrows).
class WindStreaks : public osg::Geometry {
public:
    static constexpr unsigned count = 900;

    WindStreaks();

    /// Carries them on to a time. Between frames.
    /// @param middle of where they are, and half of its side, the forest's coordinates, metres.
    void show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach);

protected:
    ~WindStreaks() override = default;

private:
    static constexpr unsigned points = 8; ///< Of a streak.
    struct Streak {
        std::array<glm::vec3, points> way; ///< The newest first.
        float life = 0.0f;                 ///< Seconds that are left.
    };

    void begin(Streak& streak, const ForestDescription& forest, const glm::vec2& middle, float reach,
               float highest);
    float chance() {
        return static_cast<float>(_random() - _random.min()) / static_cast<float>(_random.max());
    }

    std::vector<Streak> _streaks{count};
    std::minstd_rand _random;
    double _time = 0.0, _marked = 0.0; ///< Seconds: of the last call, and of the last point of ways.
    bool _began = false;
};

} // namespace osgTreeWind
