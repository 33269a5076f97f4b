// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Ground.h>

#include <functional>

namespace osgTreeWind {

/// Any callable as a ground: a formula, or a door into a host's own terrain.
///
///     description.ground = std::make_shared<FunctionGround>([](double x, double) { return 0.1 * x; });
class OSGTREEWIND_EXPORT FunctionGround final : public Ground {
public:
    /// Metres at x and y of the world's frame, NaN where there is no ground. Called from any thread, several
    /// at once. Where it throws there is no forest (Forest::create()), or no ground is drawn.
    using Function = std::function<double(double x, double y)>;

    /// @param function an empty one is a ground that is nowhere. @param area where it is asked; its `cell` is
    /// how far apart the places are between which the ground may be drawn straight.
    explicit FunctionGround(Function function, const GroundArea& area = {});

    std::optional<double> height(const glm::dvec2& place) const override;
    GroundArea area() const override { return _area; }

private:
    Function _function;
    GroundArea _area;
};

} // namespace osgTreeWind
