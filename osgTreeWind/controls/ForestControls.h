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

/// Interactive controls of a running forest and of its clock. Call them between frames.
class ForestControls {
public:
    explicit ForestControls(Forest* forest);
    /// Null after the forest was deleted; then the functions below have no effect.
    Forest* forest() const { return _forest.get(); }

    // Wind, by WindSteering.
    void changeSpeed(double metresPerSecond);
    void turnWind(double degrees);
    void changeGustiness(double by);
    void restoreWind(); ///< Restores the field and the adjustment that the host set last.

    /// Replaces the last call's source by the next kind: helicopter, fan, vortex, shelter, explosion, none.
    /// @param foot of a tree, in the wind's frame. @param height of the tree, metres. @param time seconds.
    void nextSource(const glm::dvec3& foot, double height, double time);
    void keepSource() { _placedSource.reset(); } ///< Makes nextSource() add another source.
    void removeSource();                         ///< Removes the last source of the wind.

    void changeSeason(float seasons); ///< As in Season.h.

    // These rebuild the forest with its current trees, at rest.
    void nextLaw();
    void changeGain(float factor);
    void toggleDamage();
    void toggleTiers();
    void toggleBudget(); ///< 33 ms per frame, or none.

    void toggleTierColors(); ///< Draws trees in the colours of their tiers, or in their own.

    void togglePause() { _isPaused = !_isPaused; }
    void step(); ///< Pauses, and advances the clock by 1/30 s.
    void changeClockRate(double factor);
    /// The simulation time of a frame. @param referenceTime of the host, seconds.
    double simulationTime(double referenceTime);

    /// Why the last change failed; empty if it succeeded.
    const std::string& error() const { return _error; }
    /// Status lines: wind, season, law, clock.
    std::string text() const;

private:
    void keepError(const Diagnostics& problems);
    void steerWind(const std::function<void(WindSteering&)>& change);
    void rebuildForest(const std::function<void(ForestDescription&)>& change);
    void changeSources(const std::function<void(std::vector<WindSource>&)>& change);
    std::string windText() const;

    osg::observer_ptr<Forest> _forest;
    Wind _hostWind, _modifiedWind; ///< The host's wind, and our modified copy.
    bool _isSteering = false;      ///< `_modifiedWind` was set; the host may have replaced it.
    WindSteering _steering;
    bool _isPaused = false;
    double _clockRate = 1.0, _time = 0.0;
    int _pendingSteps = 0;
    std::optional<std::size_t> _placedSource; ///< Index of the kind that nextSource() added last.
    std::optional<double> _lastReferenceTime;
    std::string _error;
};

} // namespace osgTreeWind
