// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalKernel.h>

// What the air does under the law `modal`, to as many trees at once as `Lanes` has: those of an instruction
// set (Lanes.h), for which all of it is local to a source, or one.

namespace osgTreeWind {
namespace {

/// The floats from `first` on of each number of a block.
template <typename Lanes>
class LaneColumn {
public:
    using Number = typename Lanes::Number;
    LaneColumn(const TreeLanes* numbers, std::size_t first) : _numbers(numbers), _first(first) {}
    const Number& operator[](std::size_t i) const {
        return *reinterpret_cast<const Number*>(_numbers[i].tree + _first);
    }

private:
    const TreeLanes* _numbers;
    std::size_t _first;
};

/// A TreeFactors of each tree, and what follows from it.
template <typename Lanes>
struct LaneFactors {
    using Number = typename Lanes::Number;
    Number cosine, sine, length, pace, modulus, branches, width, leaves, support, roots, leafDrag, stillDrag,
        contact, shelter;
    Number reach;  ///< Speed of a patch by that of modes: lengths over the gain.
    Number drive;  ///< Force on a mode, times the gain.
    Number weight; ///< On the shares of weight.
    Number woodDrag;

    LaneFactors(const LaneColumn<Lanes>& c, float gain)
        : cosine(c[0]), sine(c[1]), length(c[2]), pace(c[3]), modulus(c[4]), branches(c[5]), width(c[6]),
          leaves(c[7]), support(c[8]), roots(c[9]), leafDrag(c[10]), stillDrag(c[11]), contact(c[12]),
          shelter(c[13]) {
        const Number cube = length * length * length;
        reach = length * (gain > 0.0f ? 1.0f / gain : 0.0f);
        drive = gain / (pace * cube * cube);
        weight = 1.0f / (pace * length);
        woodDrag = Lanes::root(pace) * cube;
    }

    /// What has those powers, over what it is on a tree that was only scaled.
    Number grown(const SizePowers& p) const {
        return typename Lanes::Laws().nearExponential(p.modulus * modulus + p.branches * branches +
                                                      p.width * width + p.leaves * leaves +
                                                      p.support * support + p.roots * roots);
    }
    /// Share of its stiffness that weight leaves a mode: what slows it deepens its lean as well.
    /// @param stiffness, mass grown() of it.
    Number leftByWeight(const ModalModel::Mode& mode, const Number& stiffness, const Number& mass) const {
        return typename Lanes::Laws().weightLeaves(mode.weightShare * weight * mass / stiffness);
    }
};
static_assert(sizeof(TreeFactors) == 14 * sizeof(float), "LaneFactors takes them in their order");

/// The air at the patches of the trees from `first` on.
template <typename Lanes>
class ModalAir {
public:
    using Number = typename Lanes::Number;

    ModalAir(const ModalModel& model, const TreeLanes* block, std::size_t first, float gain)
        : _model(model), _speed(block + model.modes.size(), first),
          _factors({block + treeFloats(model) - sizeof(TreeFactors) / sizeof(float), first}, gain) {}

    const LaneFactors<Lanes>& factors() const { return _factors; }

    /// A wind in the trees' own axes reaches a patch.
    void meet(std::size_t p, const Number& x, const Number& y, const Number& z) {
        const ModalModel::Patch& patch = _model.patches[p];
        Number* wind = _wind + 3 * p;
        wind[0] = x;
        wind[1] = y;
        wind[2] = z;
        _square[p] = x * x + y * y + z * z;
        const Number wood = patch.woodDrag * _factors.woodDrag;
        Number swings;
        const Number relative = pass(p, _speed, _past + 3 * p, _ownShare[p], swings);
        _stillDrag[p] = wood + patch.stillDrag * _factors.stillDrag;
        _windDrag[p] = (wood + patch.leafDrag * _factors.leafDrag) * streamlined(p, relative);
        _brake[p] = typename Lanes::Laws().airBrake(_windDrag[p], _stillDrag[p], swings, relative);
    }

    /// Of a patch that was met, as the modes have their speeds: kg/s, and the air past it, x, y, z.
    const Number& brake(std::size_t p) const { return _brake[p]; }
    const Number* past(std::size_t p) const { return _past + 3 * p; }
    /// How much of the patch's own speed the air past it has: crowns of a stand shelter each other from the
    /// wind and from their own motion alike.
    const Number& ownShare(std::size_t p) const { return _ownShare[p]; }

    /// The same as the modes have other speeds, with leaves turned as they were.
    template <typename Speeds>
    Number brakeAt(std::size_t p, const Speeds& speeds) const {
        Number past[3], ownShare, swings;
        const Number relative = pass(p, speeds, past, ownShare, swings);
        return typename Lanes::Laws().airBrake(_windDrag[p], _stillDrag[p], swings, relative);
    }

private:
    /// Square of the speed of the air past a patch.
    template <typename Speeds>
    Number pass(std::size_t p, const Speeds& speeds, Number* past, Number& ownShare, Number& swings) const {
        const std::size_t modes = _model.modes.size();
        const float* lever = _model.levers.data() + 3 * modes * p;
        Number own[3];
        for (std::size_t c = 0; c < 3; ++c) {
            Number sum = Lanes::every(0.0f);
            for (std::size_t k = 0; k < modes; ++k)
                sum += lever[c * modes + k] * speeds[k];
            own[c] = sum * _factors.reach;
        }
        swings =
            typename Lanes::Laws().swinging(_square[p], own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
        ownShare = _factors.shelter + (1.0f - _factors.shelter) * swings;
        for (std::size_t c = 0; c < 3; ++c)
            past[c] = _wind[3 * p + c] - ownShare * own[c];
        return past[0] * past[0] + past[1] * past[1] + past[2] * past[2];
    }

    /// Share of its drag at 10 m/s: leaves turn out of the air that goes past them, their own motion
    /// included.
    Number streamlined(std::size_t p, const Number& relative) const {
        const ModalModel::Patch& patch = _model.patches[p];
        return typename Lanes::Laws().streamlinedShare(
            Lanes::every(patch.streamlining), Lanes::every(patch.breezeStreamlining),
            Lanes::every(_model.streamlinedTo), Lanes::root(relative));
    }

    const ModalModel& _model;
    const LaneColumn<Lanes> _speed;
    const LaneFactors<Lanes> _factors;
    Number _wind[3 * ModalDetail::maxPatches], _past[3 * ModalDetail::maxPatches],
        _ownShare[ModalDetail::maxPatches];
    Number _square[ModalDetail::maxPatches]; ///< Of the wind's speed.
    Number _windDrag[ModalDetail::maxPatches], _stillDrag[ModalDetail::maxPatches],
        _brake[ModalDetail::maxPatches];
};

} // namespace
} // namespace osgTreeWind
