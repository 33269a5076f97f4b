// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Ground.h>

#include <functional>

namespace osgTreeWind {

/// A ground from a function of x and y, such as a query of a host's terrain.
///
///     description.ground = std::make_shared<FunctionGround>([](double x, double) { return 0.1 * x; });
class OSGTREEWIND_EXPORT FunctionGround final : public Ground {
public:
    /// Height in metres at world coordinates x and y; NaN if there is no ground. Called from several threads
    /// at once. If it throws, Forest::create() fails, or the ground is not drawn.
    using Function = std::function<double(double x, double y)>;

    /// @param function empty: there is no ground anywhere. @param area in which the function is called. Its
    /// `cell` is the spacing at which the ground may be sampled for drawing.
    explicit FunctionGround(Function function, const GroundArea& area = {});

    std::optional<double> height(const glm::dvec2& place) const override;
    GroundArea area() const override { return _area; }

private:
    Function _function;
    GroundArea _area;
};

} // namespace osgTreeWind
