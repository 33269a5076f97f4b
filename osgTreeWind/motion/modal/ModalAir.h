// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalKernel.h>

// Aerodynamics of the law `modal`, for one tree or for the lanes of an instruction set (Lanes.h); internal
// linkage in both cases.

namespace osgTreeWind {
namespace {

/// Lanes from `first` on, of each number in a block.
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

/// The TreeFactors of each lane, and derived quantities.
template <typename Lanes>
struct LaneFactors {
    using Number = typename Lanes::Number;
    Number cosine, sine, length, omegaSquare, modulus, branches, width, leaves, support, roots, leafDrag,
        stillDrag, contact, shelter;
    Number velocityScale; ///< From modal to patch velocity: length over gain.
    Number forceScale;    ///< From patch to modal force, including the gain.
    Number weightScale;   ///< Scale of the weight shares.
    Number woodDrag;

    LaneFactors(const LaneColumn<Lanes>& c, float gain)
        : cosine(c[0]), sine(c[1]), length(c[2]), omegaSquare(c[3]), modulus(c[4]), branches(c[5]),
          width(c[6]), leaves(c[7]), support(c[8]), roots(c[9]), leafDrag(c[10]), stillDrag(c[11]),
          contact(c[12]), shelter(c[13]) {
        const Number cube = length * length * length;
        velocityScale = length * (gain > 0.0f ? 1.0f / gain : 0.0f);
        forceScale = gain / (omegaSquare * cube * cube);
        weightScale = 1.0f / (omegaSquare * length);
        woodDrag = Lanes::root(omegaSquare) * cube;
    }

    /// Ratio of a modal property to its value on a tree that was only scaled.
    Number sizeFactor(const SizePowers& p) const {
        return typename Lanes::Laws().nearExponential(p.modulus * modulus + p.branches * branches +
                                                      p.width * width + p.leaves * leaves +
                                                      p.support * support + p.roots * roots);
    }
    /// Share of its stiffness that gravity leaves to a mode; it reduces the frequency and increases the lean.
    /// @param stiffness, mass sizeFactor() of the mode.
    Number stiffnessLeft(const ModalModel::Mode& mode, const Number& stiffness, const Number& mass) const {
        return typename Lanes::Laws().weightLeaves(mode.weightShare * weightScale * mass / stiffness);
    }
};
static_assert(sizeof(TreeFactors) == 14 * sizeof(float), "LaneFactors reads them in this order");

/// Wind and drag at the patches of the trees from lane `first` on.
template <typename Lanes>
class ModalAir {
public:
    using Number = typename Lanes::Number;

    ModalAir(const ModalModel& model, const TreeLanes* block, std::size_t first, float gain)
        : _model(model), _speed(block + model.modes.size(), first),
          _factors({block + treeFloats(model) - sizeof(TreeFactors) / sizeof(float), first}, gain) {}

    const LaneFactors<Lanes>& factors() const { return _factors; }

    /// Sets the wind at a patch, in the trees' own axes, and computes its drag.
    void setWind(std::size_t p, const Number& x, const Number& y, const Number& z) {
        const ModalModel::Patch& patch = _model.patches[p];
        Number* wind = _wind + 3 * p;
        wind[0] = x;
        wind[1] = y;
        wind[2] = z;
        _square[p] = x * x + y * y + z * z;
        const Number wood = patch.woodDrag * _factors.woodDrag;
        Number swings;
        const Number relative = relativeMotion(p, _speed, _relativeWind + 3 * p, _ownShare[p], swings);
        _stillDrag[p] = wood + patch.stillDrag * _factors.stillDrag;
        _windDrag[p] = (wood + patch.leafDrag * _factors.leafDrag) * streamlined(p, relative);
        _brake[p] = typename Lanes::Laws().airBrake(_windDrag[p], _stillDrag[p], swings, relative);
    }

    /// Drag coefficient of a patch at the present modal speeds, kg/s, and the relative wind, x, y, z.
    const Number& brake(std::size_t p) const { return _brake[p]; }
    const Number* relativeWind(std::size_t p) const { return _relativeWind + 3 * p; }
    /// Share of the patch's own velocity in the relative wind: crowns in a stand shelter each other from the
    /// wind and from their own motion alike.
    const Number& ownShare(std::size_t p) const { return _ownShare[p]; }

    /// Drag coefficient of a patch at other modal speeds, with streamlining as at the present ones.
    template <typename Speeds>
    Number brakeAt(std::size_t p, const Speeds& speeds) const {
        Number relativeWind[3], ownShare, swings;
        const Number relative = relativeMotion(p, speeds, relativeWind, ownShare, swings);
        return typename Lanes::Laws().airBrake(_windDrag[p], _stillDrag[p], swings, relative);
    }

private:
    /// Squared speed of the relative wind at a patch.
    template <typename Speeds>
    Number relativeMotion(std::size_t p, const Speeds& speeds, Number* relativeWind, Number& ownShare,
                          Number& swings) const {
        const std::size_t modes = _model.modes.size();
        const float* lever = _model.levers.data() + 3 * modes * p;
        Number own[3];
        for (std::size_t c = 0; c < 3; ++c) {
            Number sum = Lanes::every(0.0f);
            for (std::size_t k = 0; k < modes; ++k)
                sum += lever[c * modes + k] * speeds[k];
            own[c] = sum * _factors.velocityScale;
        }
        swings =
            typename Lanes::Laws().swinging(_square[p], own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
        ownShare = _factors.shelter + (1.0f - _factors.shelter) * swings;
        for (std::size_t c = 0; c < 3; ++c)
            relativeWind[c] = _wind[3 * p + c] - ownShare * own[c];
        return relativeWind[0] * relativeWind[0] + relativeWind[1] * relativeWind[1] +
               relativeWind[2] * relativeWind[2];
    }

    /// Drag relative to that at 10 m/s: leaves streamline in the relative wind.
    Number streamlined(std::size_t p, const Number& relative) const {
        const ModalModel::Patch& patch = _model.patches[p];
        return typename Lanes::Laws().streamlinedShare(
            Lanes::every(patch.streamlining), Lanes::every(patch.breezeStreamlining),
            Lanes::every(_model.streamlinedTo), Lanes::root(relative));
    }

    const ModalModel& _model;
    const LaneColumn<Lanes> _speed;
    const LaneFactors<Lanes> _factors;
    Number _wind[3 * ModalDetail::maxPatches], _relativeWind[3 * ModalDetail::maxPatches],
        _ownShare[ModalDetail::maxPatches];
    Number _square[ModalDetail::maxPatches]; ///< Of the wind's speed.
    Number _windDrag[ModalDetail::maxPatches], _stillDrag[ModalDetail::maxPatches],
        _brake[ModalDetail::maxPatches];
};

} // namespace
} // namespace osgTreeWind
