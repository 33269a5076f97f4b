// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Stats>

#include <optional>

namespace osgTreeWind {

/// Holds the time that one view's frames take by the detail of its trees: a factor on their heights on the
/// screen, by which their tiers are chosen.
class DetailBudget {
public:
    static constexpr float least = 0.25f;

    /// The detail of a frame that is culled now, in [least, 1].
    /// @param measured by the view's camera: its "rendering" and, where it is collected, "gpu".
    /// @param milliseconds that a frame is to take, > 0.
    float follow(const osg::Stats& measured, unsigned frame, float milliseconds);

private:
    void judge(double shareOfBudget);

    float _detail = 1.0f;
    std::optional<unsigned> _asked; ///< Frame of this detail whose measure is awaited.
};

} // namespace osgTreeWind
