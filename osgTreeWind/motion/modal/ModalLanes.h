// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Lanes.h>
#include <osgTreeWind/motion/modal/ModalAir.h>

// The law `modal` for as many trees as there are lanes; compiled once per instruction set (ModalKernel.cpp).

namespace osgTreeWind {
namespace {

/// Properties of a mode on each tree.
struct LaneMode {
    real omega, forceScale, limit;
};

/// Steps the trees from lane `first` on.
class ModalLanes {
public:
    ModalLanes(const ModalStep& step, std::size_t first)
        : _model(*step.model), _modes(_model.modes.size()), _patches(_model.patches.size()), _step(step),
          _first(first), _air(_model, step.block, first, step.gain) {}

    void run() {
        turnWind();
        fitModes();
        const float h = _step.substeps > 0 ? _step.seconds / static_cast<float>(_step.substeps) : 0.0f;
        for (int i = 0; i < _step.substeps; ++i) {
            setWindAt((static_cast<float>(i) + 0.5f) / static_cast<float>(_step.substeps));
            sumForces([this](std::size_t p) { return _air.brake(p); });
            real middle[ModalDetail::maxModes];
            for (std::size_t k = 0; k < _modes; ++k)
                middle[k] = stepMode(k, 0.5f * h).speed;
            sumForces([&](std::size_t p) { return _air.brakeAt(p, middle); });
            for (std::size_t k = 0; k < _modes; ++k) {
                const LaneLaws::Swing next = stepMode(k, h);
                number(k) = next.angle;
                number(_modes + k) = next.speed;
            }
        }
        for (std::size_t i = 0; i < 3 * _patches; ++i)
            number(2 * _modes + i) = _windNow[i];
    }

private:
    real& number(std::size_t i) { return *reinterpret_cast<real*>(_step.block[i].tree + _first); }

    /// Rotates the wind at the end of the step into the trees' own axes, and bounds it.
    void turnWind() {
        const LaneColumn<Lanes> wind(_step.wind, _first);
        const real &cosine = _air.factors().cosine, &sine = _air.factors().sine;
        for (std::size_t p = 0; p < 3 * _patches; p += 3) {
            const real x = _laws.plausibleWind(wind[p]), y = _laws.plausibleWind(wind[p + 1]);
            _windNow[p] = cosine * x + sine * y;
            _windNow[p + 1] = cosine * y - sine * x;
            _windNow[p + 2] = _laws.plausibleWind(wind[p + 2]);
        }
    }

    void fitModes() {
        const LaneFactors<Lanes>& factors = _air.factors();
        for (std::size_t k = 0; k < _modes; ++k) {
            const ModalModel::Mode& mode = _model.modes[k];
            const real stiffness = factors.sizeFactor(mode.stiffness), mass = factors.sizeFactor(mode.mass);
            const real left = factors.stiffnessLeft(mode, stiffness, mass), eased = 1.0f / mass;
            _mode[k].omega = mode.omega * sqrt(factors.omegaSquare * stiffness * left * eased);
            _mode[k].forceScale = factors.forceScale * eased;
            _mode[k].limit = every(mode.limit);
        }
    }

    /// Sets the wind at a fraction of the step.
    void setWindAt(float at) {
        const auto wind = [&](std::size_t i) {
            const real before = number(2 * _modes + i);
            return before + at * (_windNow[i] - before);
        };
        for (std::size_t p = 0; p < _patches; ++p)
            _air.setWind(p, wind(3 * p), wind(3 * p + 1), wind(3 * p + 2));
    }

    /// Sums the modal forces and damping of the air, with the drag coefficient of each patch.
    template <typename BrakeOf>
    void sumForces(const BrakeOf& brakeOf) {
        for (std::size_t k = 0; k < _modes; ++k)
            _force[k] = _brake[k] = every(0.0f);
        for (std::size_t p = 0; p < _patches; ++p) {
            const float* lever = _model.levers.data() + 3 * _modes * p;
            const float* brakes = _model.brakes.data() + _modes * p;
            const real brake = brakeOf(p);
            for (std::size_t c = 0; c < 3; ++c) {
                const real force = brake * _air.relativeWind(p)[c];
                for (std::size_t k = 0; k < _modes; ++k)
                    _force[k] += lever[c * _modes + k] * force;
            }
            const real follows = brake * _air.ownShare(p);
            for (std::size_t k = 0; k < _modes; ++k)
                _brake[k] += brakes[k] * follows;
        }
    }

    LaneLaws::Swing stepMode(std::size_t k, float seconds) {
        const LaneMode& mode = _mode[k];
        LaneLaws::Swing start;
        start.angle = number(k);
        start.speed = number(_modes + k);
        return _laws.modeStep(start, mode.forceScale * _force[k],
                              mode.forceScale * _air.factors().velocityScale * _brake[k], mode.omega,
                              _air.factors().contact + _model.dampingRatio, mode.limit, every(seconds));
    }

    LaneLaws _laws;
    const ModalModel& _model;
    const std::size_t _modes, _patches;
    const ModalStep& _step;
    const std::size_t _first;
    ModalAir<Lanes> _air;
    LaneMode _mode[ModalDetail::maxModes];
    real _force[ModalDetail::maxModes], _brake[ModalDetail::maxModes];
    real _windNow[3 * ModalDetail::maxPatches];
};

} // namespace
} // namespace osgTreeWind
