// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Lanes.h>
#include <osgTreeWind/motion/modal/ModalKernel.h>

// The law `modal` for eight trees at once, compiled once for each instruction set (ModalKernel.cpp chooses).

namespace osgTreeWind {
namespace {

/// The floats from `first` on of each number of a block.
class LaneColumn {
public:
    LaneColumn(TreeLanes* numbers, int first) : _numbers(numbers), _first(first) {}
    real& operator[](std::size_t i) const { return *reinterpret_cast<real*>(_numbers[i].tree + _first); }
    LaneColumn operator+(std::size_t i) const { return {_numbers + i, _first}; }

private:
    TreeLanes* _numbers;
    int _first;
};

/// A TreeFactors of each tree, and what follows from it.
struct LaneFactors {
    real cosine, sine, length, pace, modulus, branches, width, leaves, leafDrag, stillDrag;
    real reach;  ///< Speed of a patch by that of modes: lengths over the gain.
    real drive;  ///< Force on a mode, times the gain.
    real weight; ///< On the shares of weight.
    real woodDrag;

    LaneFactors(const LaneColumn& c, float gain)
        : cosine(c[0]), sine(c[1]), length(c[2]), pace(c[3]), modulus(c[4]), branches(c[5]), width(c[6]),
          leaves(c[7]), leafDrag(c[8]), stillDrag(c[9]) {
        const real cube = length * length * length;
        reach = length * (gain > 0.0f ? 1.0f / gain : 0.0f);
        drive = gain / (pace * cube * cube);
        weight = 1.0f / (pace * length);
        woodDrag = sqrt(pace) * cube;
    }
};
static_assert(sizeof(TreeFactors) == 10 * sizeof(float), "LaneFactors takes them in their order");

/// What a mode is on each tree.
struct LaneMode {
    real pace, drive, limit;
};

/// The trees from `first` on, as many as there are lanes, through a step.
class ModalLanes {
public:
    ModalLanes(const ModalStep& step, int first)
        : _model(*step.model), _modes(_model.modes.size()), _patches(_model.patches.size()), _step(step),
          _first(first), _amplitude(step.block, first), _speed(_amplitude + _modes), _wind(_speed + _modes),
          _factors(_wind + 3 * _patches, step.gain) {}

    void run() {
        turnWind();
        fitModes();
        const float h = _step.substeps > 0 ? _step.seconds / static_cast<float>(_step.substeps) : 0.0f;
        for (int i = 0; i < _step.substeps; ++i) {
            const float at = (static_cast<float>(i) + 0.5f) / static_cast<float>(_step.substeps);
            blow(at);
            real middle[ModalDetail::maxModes];
            push(_speed);
            for (std::size_t k = 0; k < _modes; ++k)
                middle[k] = swing(k, 0.5f * h).speed;
            push(middle);
            for (std::size_t k = 0; k < _modes; ++k) {
                const LaneLaws::Swing next = swing(k, h);
                _amplitude[k] = next.angle;
                _speed[k] = next.speed;
            }
        }
        for (std::size_t i = 0; i < 3 * _patches; ++i)
            _wind[i] = _windNow[i];
    }

private:
    /// The wind at the end of the step in the trees' own axes, bounded.
    void turnWind() {
        const LaneColumn wind(_step.wind, _first);
        for (std::size_t p = 0; p < 3 * _patches; p += 3) {
            const real x = _laws.plausibleWind(wind[p]), y = _laws.plausibleWind(wind[p + 1]);
            _windNow[p] = _factors.cosine * x + _factors.sine * y;
            _windNow[p + 1] = _factors.cosine * y - _factors.sine * x;
            _windNow[p + 2] = _laws.plausibleWind(wind[p + 2]);
        }
    }

    real grown(const SizePowers& p) const {
        return _laws.nearExponential(p.modulus * _factors.modulus + p.branches * _factors.branches +
                                     p.width * _factors.width + p.leaves * _factors.leaves);
    }

    void fitModes() {
        for (std::size_t k = 0; k < _modes; ++k) {
            const ModalModel::Mode& mode = _model.modes[k];
            const real stiffness = grown(mode.stiffness), mass = grown(mode.mass);
            // Weight slows a tree as more mass would.
            const real left = _laws.weightLeaves(mode.weightShare * _factors.weight * mass / stiffness);
            _mode[k].pace = mode.pace * sqrt(_factors.pace * stiffness * left / mass);
            _mode[k].drive = _factors.drive * left / mass;
            _mode[k].limit = every(mode.limit);
        }
    }

    /// The wind part of the way through the step.
    void blow(float at) {
        const real upTo = every(_model.streamlinedTo);
        for (std::size_t p = 0; p < _patches; ++p) {
            real* air = _air + 3 * p;
            for (int c = 0; c < 3; ++c)
                air[c] = _wind[3 * p + c] + at * (_windNow[3 * p + c] - _wind[3 * p + c]);
            const ModalModel::Patch& patch = _model.patches[p];
            _airSquare[p] = air[0] * air[0] + air[1] * air[1] + air[2] * air[2];
            const real wood = patch.woodDrag * _factors.woodDrag;
            _windDrag[p] = (wood + patch.leafDrag * _factors.leafDrag) *
                           _laws.streamlinedShare(every(patch.streamlining), upTo, sqrt(_airSquare[p]));
            _stillDrag[p] = wood + patch.stillDrag * _factors.stillDrag;
        }
    }

    /// The forces of the air at the start of the step, braked as it is when the modes have these speeds.
    template <typename Speeds>
    void push(const Speeds& speeds) {
        for (std::size_t k = 0; k < _modes; ++k)
            _force[k] = _brake[k] = every(0.0f);
        for (std::size_t p = 0; p < _patches; ++p) {
            const float* lever = _model.levers.data() + 3 * _modes * p;
            const float* brakes = _model.brakes.data() + _modes * p;
            const real* air = _air + 3 * p;
            real own[3], relative[3], start[3];
            for (int c = 0; c < 3; ++c) {
                own[c] = start[c] = every(0.0f);
                for (std::size_t k = 0; k < _modes; ++k) {
                    own[c] += lever[c * _modes + k] * speeds[k];
                    start[c] += lever[c * _modes + k] * _speed[k];
                }
                own[c] *= _factors.reach;
                relative[c] = air[c] - own[c];
                start[c] = air[c] - _factors.reach * start[c];
            }
            const real brake = _laws.airBrake(_windDrag[p], _stillDrag[p], _airSquare[p],
                                              own[0] * own[0] + own[1] * own[1] + own[2] * own[2],
                                              relative[0] * relative[0] + relative[1] * relative[1] +
                                                  relative[2] * relative[2]);
            for (int c = 0; c < 3; ++c) {
                const real force = brake * start[c];
                for (std::size_t k = 0; k < _modes; ++k)
                    _force[k] += lever[c * _modes + k] * force;
            }
            for (std::size_t k = 0; k < _modes; ++k)
                _brake[k] += brakes[k] * brake;
        }
    }

    LaneLaws::Swing swing(std::size_t k, float seconds) {
        const LaneMode& mode = _mode[k];
        LaneLaws::Swing start;
        start.angle = _amplitude[k];
        start.speed = _speed[k];
        return _laws.modeStep(start, mode.drive * _force[k], mode.drive * _factors.reach * _brake[k],
                              mode.pace, every(_model.dampingRatio), mode.limit, every(seconds));
    }

    mutable LaneLaws _laws;
    const ModalModel& _model;
    const std::size_t _modes, _patches;
    const ModalStep& _step;
    const int _first;
    const LaneColumn _amplitude, _speed, _wind;
    const LaneFactors _factors;
    LaneMode _mode[ModalDetail::maxModes];
    real _force[ModalDetail::maxModes], _brake[ModalDetail::maxModes];
    real _windNow[3 * ModalDetail::maxPatches], _air[3 * ModalDetail::maxPatches];
    real _airSquare[ModalDetail::maxPatches], _windDrag[ModalDetail::maxPatches],
        _stillDrag[ModalDetail::maxPatches];
};

} // namespace
} // namespace osgTreeWind
