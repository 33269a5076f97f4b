// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/CarriedSway.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double certainty = 1.0e-3; // what the least of the modes counts of the most, so that none runs away

float topOf(const ModalModel& model) {
    float top = 1.0e-6f;
    for (const ModalModel::Patch& patch : model.patches)
        top = std::max(top, patch.place.z);
    return top;
}

} // namespace

CarriedSway::CarriedSway(const ModalModel& from, float fromLength, const ModalModel& to, float toLength)
    : _from(from), _to(to), _length(static_cast<double>(fromLength) / static_cast<double>(toLength)) {
    const float fromTop = topOf(from), toTop = topOf(to);
    for (const ModalModel::Patch& patch : to.patches) {
        const auto distance = [&](const ModalModel::Patch& other) {
            return glm::distance(patch.place / toTop, other.place / fromTop);
        };
        _patches.push_back(static_cast<std::size_t>(
            std::min_element(from.patches.begin(), from.patches.end(),
                             [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
            from.patches.begin()));
    }
    const std::size_t modes = to.modes.size();
    std::vector<std::vector<double>> squares(modes, std::vector<double>(modes, 0.0));
    for (std::size_t row = 0; row < 3 * to.patches.size(); ++row)
        for (std::size_t i = 0; i < modes; ++i)
            for (std::size_t k = 0; k < modes; ++k)
                squares[i][k] += static_cast<double>(to.levers[row * modes + i]) *
                                 static_cast<double>(to.levers[row * modes + k]);
    double most = 1.0e-12;
    for (std::size_t i = 0; i < modes; ++i)
        most = std::max(most, squares[i][i]);
    for (std::size_t i = 0; i < modes; ++i)
        squares[i][i] += certainty * most;
    _factor = squares;
    for (std::size_t i = 0; i < modes; ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            double rest = squares[i][k];
            for (std::size_t j = 0; j < k; ++j)
                rest -= _factor[i][j] * _factor[k][j];
            _factor[i][k] = i == k ? std::sqrt(rest) : rest / _factor[k][k];
        }
}

std::vector<float> CarriedSway::carried(const float* amplitudes) const {
    const std::size_t modes = _to.modes.size(), before = _from.modes.size();
    std::vector<double> q(modes, 0.0);
    for (std::size_t row = 0; row < 3 * _patches.size(); ++row) {
        double moved = 0.0;
        const float* levers = _from.levers.data() + (3 * _patches[row / 3] + row % 3) * before;
        for (std::size_t k = 0; k < before; ++k)
            moved += _length * static_cast<double>(levers[k]) * static_cast<double>(amplitudes[k]);
        for (std::size_t k = 0; k < modes; ++k)
            q[k] += static_cast<double>(_to.levers[row * modes + k]) * moved;
    }
    for (std::size_t i = 0; i < modes; ++i) {
        for (std::size_t j = 0; j < i; ++j)
            q[i] -= _factor[i][j] * q[j];
        q[i] /= _factor[i][i];
    }
    for (std::size_t i = modes; i-- > 0;) {
        for (std::size_t j = i + 1; j < modes; ++j)
            q[i] -= _factor[j][i] * q[j];
        q[i] /= _factor[i][i];
    }
    return {q.begin(), q.end()};
}

} // namespace osgTreeWind
