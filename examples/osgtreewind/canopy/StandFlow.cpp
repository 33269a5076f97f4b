// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/StandFlow.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double karman = 0.4;
/// Wilson and Shaw 1977: lengths of transport, of the return to isotropy and of dissipation over the mixing
/// length, and the part of the pressure term that the shear makes at once.
constexpr double transport = 0.39, isotropy = 0.85, dissipation = 16.58, rapid = 0.077;
/// Roughness length of the ground over h, for the drag of bare ground of Raupach 1994, u*^2 / U(h)^2 = 0.003.
const double groundRoughness = math::exp(-karman / std::sqrt(0.003));
/// Variances over u*^2 where production is dissipation, in the surface layer: of all components, and upward.
const double energyAbove = math::pow(dissipation, 2.0 / 3.0),
             upAbove = energyAbove / 3.0 - 2.0 * isotropy * energyAbove / dissipation;

using Numbers = std::vector<double>;

/// Flux down through the face between two cells: `up` times the value above less `down` times that below.
struct Exchange {
    double up = 0.0, down = 0.0;
};

/// Heights are over the height of the stand, velocities over u* at its top.
class Closure {
public:
    Closure(const std::vector<float>& drag, std::size_t steps)
        : _inside(drag.size() * steps), _count(_inside + _inside / 2),
          _step(1.0 / static_cast<double>(_inside)), _drag(_count), _sink(_count), _source(_count),
          _found(_count), _share(_count), _wind(_count), _energy(_count), _up(_count), _length(_count),
          _stress(_count + 1), _faces(_count + 1) {
        for (std::size_t i = 0; i < _count; ++i) {
            const double layer = i < _inside ? static_cast<double>(drag[i / steps]) : 0.0,
                         depth = std::min(at(i), 1.0), part = 0.05 + depth * depth;
            _drag[i] = layer > 0.0 ? std::min(layer, 100.0) / static_cast<double>(steps) : 0.0;
            _wind[i] = 0.1 + 5.0 * at(i);
            _energy[i] = part * energyAbove;
            _up[i] = part * upAbove;
        }
        for (int i = 0; i < 200 && iterate() > 1e-3; ++i) {
        }
    }

    StandFlow flow() const {
        StandFlow flow;
        const double top = between(_wind, _inside), energy = between(_energy, _inside);
        flow.friction = static_cast<float>(std::sqrt(_stress[_inside]) / top);
        flow.displacement = static_cast<float>(_displacement);
        for (std::size_t i = 0; i <= _inside; ++i) {
            flow.mean.push_back(static_cast<float>((i > 0 ? between(_wind, i) : _wind[0]) / top));
            flow.stress.push_back(static_cast<float>(_stress[i] / _stress[_inside]));
            flow.turbulence.push_back(
                static_cast<float>(std::sqrt((i > 0 ? between(_energy, i) : _energy[0]) / energy)));
        }
        return flow;
    }

private:
    double at(std::size_t cell) const { return (static_cast<double>(cell) + 0.5) * _step; }
    static double between(const Numbers& numbers, std::size_t face) {
        return 0.5 * (numbers[face - 1] + numbers[face]);
    }
    /// The transport of a variance through a face. The top face lies half a cell from a fixed value.
    double diffusion(std::size_t face) const {
        if (face == _count)
            return 2.0 * std::sqrt(energyAbove) * transport *
                   lengthAbove(static_cast<double>(_count) * _step) / _step;
        return face > 0 ? std::sqrt(between(_energy, face)) * transport * between(_length, face) / _step
                        : 0.0;
    }
    double lengthAbove(double height) const { return karman * (height - _displacement); }

    /// Solves for `_found`, for which exchange, sink and source of each cell are in balance.
    void balance() {
        double below = 0.0, given = 0.0;
        for (std::size_t i = 0; i < _count; ++i) {
            const double own = _sink[i] + _faces[i + 1].down + _faces[i].up - _faces[i].down * below;
            below = _share[i] = _faces[i + 1].up / own;
            given = _found[i] = (_source[i] + _faces[i].down * given) / own;
        }
        for (std::size_t i = _count - 1; i > 0; --i)
            _found[i - 1] += _share[i - 1] * _found[i];
    }
    /// Adds the transport of a variance, times a factor, and solves for `_found`. @param above its value
    /// above.
    void balanceTransported(double factor, double above) {
        for (std::size_t face = 0; face < _count; ++face) {
            const double by = factor * diffusion(face);
            _faces[face] = {by, by};
        }
        _faces[_count] = {};
        const double top = factor * diffusion(_count);
        _sink[_count - 1] += top;
        _source[_count - 1] += top * above;
        balance();
    }
    /// Moves numbers toward those found. @return the largest change.
    double approach(Numbers& numbers) const {
        double change = 0.0;
        for (std::size_t i = 0; i < _count; ++i) {
            const double by = 0.5 * (_found[i] - numbers[i]);
            change = std::max(change, std::abs(by));
            numbers[i] += by;
        }
        return change;
    }

    double iterate() {
        for (std::size_t i = 0; i < _count; ++i) // Katul et al. 2004
            _length[i] = at(i) > 1.0 ? lengthAbove(at(i)) : std::min(lengthAbove(1.0), karman * at(i));
        const double change = findWind() + findTurbulence();
        double sum = 0.0;
        for (std::size_t face = 1; face <= _inside; ++face)
            sum += 0.5 * (_stress[face - 1] + _stress[face]) * _step;
        const double displacement = std::min(1.0 - sum / _stress[_inside], 0.98); // Thom 1971
        const double by = 0.5 * (displacement - _displacement);
        _displacement += by;
        return change + std::abs(by);
    }

    /// The budget of the stress gives it as a flux down the gradient and, since the divergence of the stress
    /// is the drag, a flux down the gradient of the drag times sqrt(energy).
    double findWind() {
        const double toGround = karman / math::log(0.5 * _step / groundRoughness);
        const auto transported = [this](std::size_t i) {
            return std::sqrt(_energy[i]) * transport * _length[i] * force(i) / _step;
        };
        for (std::size_t i = 0; i < _count; ++i) {
            _sink[i] = force(i);
            _source[i] = 0.0;
        }
        for (std::size_t face = 1; face < _count; ++face) {
            const double energy = between(_energy, face),
                         scale = 3.0 * isotropy * between(_length, face) / (std::sqrt(energy) * _step),
                         gradient = scale * std::max(between(_up, face) - rapid * energy, 0.01 * energy);
            _faces[face] = {gradient + 2.0 * scale * transported(face),
                            gradient + 2.0 * scale * transported(face - 1)};
        }
        _faces[0] = _faces[_count] = {};
        _sink[0] += toGround * toGround * _wind[0];
        _source[_count - 1] = 1.0; // the stress above the stand
        balance();
        const double change = approach(_wind);
        _stress[_count] = 1.0;
        for (std::size_t i = _count; i > 0; --i)
            _stress[i - 1] = std::max(_stress[i] - force(i - 1) * _wind[i - 1], 0.0);
        return change;
    }
    /// Force on a cell over its wind.
    double force(std::size_t i) const { return _drag[i] * _wind[i]; }

    double findTurbulence() {
        const double energyLoss = 2.0 / dissipation, toIsotropy = 1.0 / (3.0 * isotropy);
        Numbers up = _up;
        for (std::size_t i = 0; i < _count; ++i) {
            const double rate = std::sqrt(_energy[i]) / _length[i] * _step;
            _sink[i] = rate * toIsotropy;
            _source[i] = rate * _energy[i] * (toIsotropy - energyLoss) / 3.0;
        }
        balanceTransported(3.0, upAbove);
        approach(up);
        for (std::size_t i = 0; i < _count; ++i)
            up[i] = std::clamp(up[i], 0.02 * _energy[i], 0.6 * _energy[i]);

        for (std::size_t i = 0; i < _count; ++i) {
            const double shearBelow = i > 0 ? _wind[i] - _wind[i - 1] : 0.0,
                         shearAbove = i + 1 < _count ? _wind[i + 1] - _wind[i] : _step / lengthAbove(at(i)),
                         upward = (i > 0 ? diffusion(i) * (_up[i - 1] - _up[i]) : 0.0) +
                                  (diffusion(i + 1) * ((i + 1 < _count ? _up[i + 1] : upAbove) - _up[i]));
            const double produced = _stress[i] * shearBelow + _stress[i + 1] * shearAbove +
                                    2.0 * force(i) * _wind[i] * _wind[i] + 2.0 * upward;
            _sink[i] = energyLoss * std::sqrt(_energy[i]) / _length[i] * _step +
                       std::max(-produced, 0.0) / _energy[i];
            _source[i] = std::max(produced, 0.0);
        }
        balanceTransported(1.0, energyAbove);
        const double change = approach(_energy);
        _up = std::move(up);
        return change;
    }

    std::size_t _inside, _count; ///< Cells in the stand; with those up to 1.5 times its height.
    double _step, _displacement = 0.7;
    Numbers _drag, _sink, _source, _found, _share;
    Numbers _wind, _energy, _up, _length, _stress; ///< `_stress` is between cells.
    std::vector<Exchange> _faces;
};

} // namespace

StandFlow solveStandFlow(const std::vector<float>& drag, std::size_t steps) {
    return Closure(drag, steps).flow();
}

} // namespace osgTreeWind
