// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/SwayTransfer.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Tikhonov term over the largest modal square; keeps amplitudes bounded.
constexpr double regularization = 1.0e-3;

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

SwayTransfer::SwayTransfer(const ModalModel& from, float fromLength, const ModalModel& to, float toLength)
    : _oldModeCount(from.modes.size()), _patches(nearestPatches(to, topOf(to), from, topOf(from))) {
    const auto modes = static_cast<Eigen::Index>(to.modes.size());
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(modes, modes);
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(modes, static_cast<Eigen::Index>(_oldModeCount));
    for (std::size_t p = 0; p < _patches.size(); ++p) {
        const Levers levers = leversOf(to, p);
        squares += levers * levers.transpose();
        cross += levers * leversOf(from, _patches[p]).transpose();
    }
    squares.diagonal().array() += regularization * std::max(squares.diagonal().maxCoeff(), 1.0e-12);
    const double length = static_cast<double>(fromLength) / static_cast<double>(toLength);
    const Eigen::MatrixXd result = length * squares.llt().solve(cross);
    _matrix.assign(result.data(), result.data() + result.size());
}

std::vector<float> SwayTransfer::transfer(const float* amplitudes) const {
    const auto before = static_cast<Eigen::Index>(_oldModeCount),
               after = static_cast<Eigen::Index>(_matrix.size()) / before;
    const Eigen::VectorXf result = (Eigen::Map<const Eigen::MatrixXd>(_matrix.data(), after, before) *
                                    Eigen::Map<const Eigen::VectorXf>(amplitudes, before).cast<double>())
                                       .cast<float>();
    return {result.data(), result.data() + result.size()};
}

} // namespace osgTreeWind
