// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/CarriedSway.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr double certainty = 1.0e-3; // what the least of the modes counts of the most, so that none runs away

float topOf(const ModalModel& model) {
    float top = 1.0e-6f;
    for (const ModalModel::Patch& patch : model.patches)
        top = std::max(top, patch.place.z);
    return top;
}

using Levers = Eigen::Matrix<double, Eigen::Dynamic, 3>; // of a patch, per mode and axis

Levers leversOf(const ModalModel& model, std::size_t patch) {
    const auto modes = static_cast<Eigen::Index>(model.modes.size());
    const float* levers = model.levers.data() + 3 * patch * model.modes.size();
    return Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3>>(levers, modes, 3).cast<double>();
}

} // namespace

CarriedSway::CarriedSway(const ModalModel& from, float fromLength, const ModalModel& to, float toLength)
    : _before(from.modes.size()), _patches(nearestPatches(to, topOf(to), from, topOf(from))) {
    const auto modes = static_cast<Eigen::Index>(to.modes.size());
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(modes, modes);
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(modes, static_cast<Eigen::Index>(_before));
    for (std::size_t p = 0; p < _patches.size(); ++p) {
        const Levers levers = leversOf(to, p);
        squares += levers * levers.transpose();
        moved += levers * leversOf(from, _patches[p]).transpose();
    }
    squares.diagonal().array() += certainty * std::max(squares.diagonal().maxCoeff(), 1.0e-12);
    const double length = static_cast<double>(fromLength) / static_cast<double>(toLength);
    const Eigen::MatrixXd carried = length * squares.llt().solve(moved);
    _carried.assign(carried.data(), carried.data() + carried.size());
}

std::vector<float> CarriedSway::carried(const float* amplitudes) const {
    const auto before = static_cast<Eigen::Index>(_before),
               after = static_cast<Eigen::Index>(_carried.size()) / before;
    const Eigen::VectorXf carried = (Eigen::Map<const Eigen::MatrixXd>(_carried.data(), after, before) *
                                     Eigen::Map<const Eigen::VectorXf>(amplitudes, before).cast<double>())
                                        .cast<float>();
    return {carried.data(), carried.data() + carried.size()};
}

} // namespace osgTreeWind
