// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/wind/WindSteering.h>

#include <osg/observer_ptr>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// What a person changes on a forest while it runs, and its clock. Between frames.
class ForestControls {
public:
    explicit ForestControls(Forest* forest);
    /// Null once it is gone; then nothing below does anything.
    Forest* forest() const { return _forest.get(); }

    // The wind (WindSteering).
    void changeSpeed(double metresPerSecond);
    void turnWind(double degrees);
    void changeGustiness(double by);
    /// The field and the adjustment that it had when the host last set it.
    void restoreWind();

    /// Puts the next source of wind beside a tree in place of the present one: a helicopter, a fan, a whirl,
    /// a shelter, an explosion, then no source.
    void nextSource(const glm::dvec3& foot, double height, double time);
    void keepSource() { _byHand.reset(); } ///< The next one comes beside it.
    void removeSource();                   ///< The last of the wind's.

    void changeSeason(float seasons); ///< Season.h

    // Trees are put up anew for these, at rest, as they are by now.
    void nextLaw();
    void changeGain(float factor);
    void switchDamage();
    void switchTiers();
    void switchBudget(); ///< 33 ms a frame, or none.

    /// Each tree in the colour of its tier, or in its own.
    void switchTierColors();

    void pause() { _isPaused = !_isPaused; }
    void step(); ///< On by a thirtieth of a second of a forest that pauses.
    void changePace(double factor);
    /// That of a frame at a host's own time, seconds.
    double simulationTime(double referenceTime);

    /// Why the last change was not made, for a line; empty: it was.
    const std::string& message() const { return _message; }
    /// Wind, season, law and clock, a line each.
    std::string text() const;

private:
    void steer(const std::function<void(WindSteering&)>& change);
    void grow(const std::function<void(ForestDescription&)>& change);
    void changeSources(const std::function<void(std::vector<WindSource>&)>& change);
    std::string windText() const;

    osg::observer_ptr<Forest> _forest;
    Wind _given, _set;    ///< The host's wind, and our modified copy.
    bool _steers = false; ///< The forest's wind is `_set`, unless the host set another.
    WindSteering _steering;
    bool _isPaused = false;
    double _pace = 1.0, _time = 0.0;
    int _steps = 0;                     ///< That wait.
    std::optional<std::size_t> _byHand; ///< Which of them is the last source of the wind.
    std::optional<double> _reference;
    std::string _message;
};

} // namespace osgTreeWind
