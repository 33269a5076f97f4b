// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Stats>

#include <optional>

namespace osgTreeWind {

/// Controls the detail of the trees in one view so that its frames stay within a time budget. Detail is a
/// factor on the screen heights from which the tiers of the trees are chosen.
class DetailBudget {
public:
    static constexpr float minDetail = 0.25f;

    /// @return the detail for the frame that is about to be culled, in [minDetail, 1].
    /// @param measured statistics of the view's camera: "rendering" and, if collected, "gpu".
    /// @param milliseconds budget of a frame, > 0.
    float updateDetail(const osg::Stats& measured, unsigned frame, float milliseconds);

private:
    void adjustDetail(double shareOfBudget);

    float _detail = 1.0f;
    std::optional<unsigned> _pendingFrame; ///< First frame with this detail; its measurement is awaited.
};

} // namespace osgTreeWind
