// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GridWind.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/Interpolation.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/ThesisWind.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

bool allFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// @param expected a double, so that a product of sizes does not overflow.
/// @param shape explains the count in the message.
void checkValues(const std::vector<float>& values, double expected, const std::string& shape,
                 Diagnostics& problems) {
    if (static_cast<double>(values.size()) != expected)
        problems.push_back(keyProblem("values", "expected " + numberText(expected) + " numbers (" + shape +
                                                    "), found " + std::to_string(values.size())));
    const auto bad = std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
    if (bad != values.end())
        problems.push_back(keyProblem("values", "expected finite m/s, found " + numberText(*bad) +
                                                    " at index " + std::to_string(bad - values.begin())));
}

/// Strides of Grid::heights; 0 where a height holds for all points or all times.
struct HeightStrides {
    std::size_t point = 0, layer = 1, step = 0;
};

HeightStrides heightStrides(const GridWind::Grid& grid) {
    const auto layers = static_cast<std::size_t>(grid.points.z);
    const std::size_t perLayer =
        static_cast<std::size_t>(grid.points.x) * static_cast<std::size_t>(grid.points.y);
    if (grid.heights.size() == layers)
        return {};
    return {1, perLayer, grid.heights.size() == perLayer * layers ? 0 : perLayer * layers};
}

void checkHeights(const GridWind::Grid& grid, Diagnostics& problems) {
    const std::size_t layers = static_cast<std::size_t>(grid.points.z), points = grid.values.size() / 3,
                      perStep = points / std::max<std::size_t>(1, grid.times.size()),
                      count = grid.heights.size();
    if (count != layers && count != perStep && count != points) {
        problems.push_back(
            keyProblem("heights", "expected one for each layer, point, or point and time, found " +
                                      std::to_string(count)));
        return;
    }
    const HeightStrides stride = heightStrides(grid);
    for (std::size_t i = 0; i < count; ++i) {
        const bool lowest = i / stride.layer % layers == 0;
        if (std::isfinite(grid.heights[i]) && (lowest || grid.heights[i] > grid.heights[i - stride.layer]))
            continue;
        problems.push_back(keyProblem("heights", "expected finite metres, increasing upward, found " +
                                                     numberText(grid.heights[i]) + " at index " +
                                                     std::to_string(i)));
        return;
    }
}

/// Of all points and times, metres.
double lowestLayer(const GridWind::Grid& grid) {
    return grid.heights.empty()
               ? grid.origin.z
               : static_cast<double>(*std::min_element(grid.heights.begin(), grid.heights.end()));
}

void checkRoughness(const GridWind::Grid& grid, Diagnostics& problems) {
    if (grid.roughness == 0.0)
        return;
    const double lowest = lowestLayer(grid);
    if (!grid.aboveGround)
        problems.push_back(keyProblem("roughness", "expected heights above the ground, which it needs"));
    else if (!LogProfile{lowest, grid.roughness}.valid())
        problems.push_back(keyProblem("roughness", "expected above 0 and below the lowest height, " +
                                                       numberText(lowest) + " m, found " +
                                                       numberText(grid.roughness)));
}

/// The grid at one time.
class Sampler {
public:
    Sampler(const GridWind::Grid& grid, double time)
        : _grid(grid), _nx(static_cast<std::size_t>(grid.points.x)),
          _ny(static_cast<std::size_t>(grid.points.y)), _nz(static_cast<std::size_t>(grid.points.z)),
          _time(grid.times.empty() ? Interpolation{} : interpolationAtTime(time, grid.times)),
          _height(heightStrides(grid)) {}

    glm::vec3 at(const WindPlace& place) const {
        const double z = _grid.aboveGround ? place.height : place.position.z;
        const glm::dvec3 position(place.position.x, place.position.y, z),
            index = (position - _grid.origin) / _grid.cell;
        const Interpolation x = interpolationAtIndex(index.x, _nx), y = interpolationAtIndex(index.y, _ny);
        const auto profile = [&](std::size_t step) {
            return _grid.roughness > 0.0 ? profileFactor(z, heightOf(0, step, x, y)) : 1.0;
        };
        if (_grid.heights.empty())
            return interpolate(x, y, profile,
                               [&](std::size_t) { return interpolationAtIndex(index.z, _nz); });
        return interpolate(x, y, profile, [&](std::size_t step) { return layersAround(z, step, x, y); });
    }

private:
    /// @param profile factor outside the layers, and @param layers around the place, both by time step.
    template <typename Profile, typename Layers>
    glm::vec3 interpolate(const Interpolation& x, const Interpolation& y, const Profile& profile,
                          const Layers& layers) const {
        const auto velocityAt = [&](std::size_t step) {
            return profile(step) * inStep(step, x, y, layers(step));
        };
        glm::dvec3 result = velocityAt(_time.lower);
        if (_time.fraction > 0.0)
            result = _time.mix(result, velocityAt(_time.upper));
        return clampedVelocity(result);
    }

    /// The factor of the logarithmic profile outside the layers.
    double profileFactor(double z, double lowest) const {
        return _nz == 1 || z < lowest ? LogProfile{lowest, _grid.roughness}.factor(z) : 1.0;
    }

    double heightOf(std::size_t layer, std::size_t step, const Interpolation& x,
                    const Interpolation& y) const {
        if (_grid.heights.empty())
            return _grid.origin.z + static_cast<double>(layer) * _grid.cell.z;
        const float* heights = _grid.heights.data() + step * _height.step + layer * _height.layer;
        if (_height.point == 0)
            return *heights;
        const float *south = heights + y.lower * _nx, *north = heights + y.upper * _nx;
        return y.mix(x.mix<double>(south[x.lower], south[x.upper]),
                     x.mix<double>(north[x.lower], north[x.upper]));
    }

    Interpolation layersAround(double z, std::size_t step, const Interpolation& x,
                               const Interpolation& y) const {
        std::size_t below = 0, above = _nz - 1;
        const double lowest = heightOf(below, step, x, y), highest = heightOf(above, step, x, y);
        if (!(z > lowest))
            return {below, below, 0.0};
        if (z >= highest)
            return {above, above, 0.0};
        while (above - below > 1) {
            const std::size_t middle = (below + above) / 2;
            (heightOf(middle, step, x, y) > z ? above : below) = middle;
        }
        const double floor = heightOf(below, step, x, y);
        return {below, above, (z - floor) / (heightOf(above, step, x, y) - floor)};
    }

    glm::dvec3 inStep(std::size_t step, const Interpolation& x, const Interpolation& y,
                      const Interpolation& z) const {
        const glm::dvec3 low = inLayer(step * _nz + z.lower, x, y);
        return z.fraction > 0.0 ? z.mix(low, inLayer(step * _nz + z.upper, x, y)) : low;
    }

    glm::dvec3 inLayer(std::size_t layer, const Interpolation& x, const Interpolation& y) const {
        const std::size_t south = (layer * _ny + y.lower) * _nx, north = (layer * _ny + y.upper) * _nx;
        return y.mix(x.mix(value(south + x.lower), value(south + x.upper)),
                     x.mix(value(north + x.lower), value(north + x.upper)));
    }

    glm::dvec3 value(std::size_t point) const {
        const float* v = _grid.values.data() + 3 * point;
        return {v[0], v[1], v[2]};
    }

    const GridWind::Grid& _grid;
    std::size_t _nx, _ny, _nz;
    Interpolation _time;
    HeightStrides _height;
};

} // namespace

GridWind::GridWind(Grid grid) : _grid(std::move(grid)) {
    if (_grid.deviations.empty())
        return;
    Grid deviations = _grid;
    deviations.roughness = 0.0; // it is nearly constant near the ground
    for (std::size_t i = 0; i < _grid.values.size(); ++i)
        deviations.values[i] = i % 3 == 0 ? _grid.deviations[i / 3] : 0.0f;
    deviations.deviations.clear();
    _turbulence.reset(new GridWind(std::move(deviations)));
}

Diagnostics GridWind::check(const Grid& grid) {
    Diagnostics problems = checkTimes(grid.times);
    const glm::ivec3& n = grid.points;
    const glm::dvec3& cell = grid.cell;
    if (!allFinite(grid.origin))
        problems.push_back(keyProblem("origin", "expected finite metres"));
    if (!allFinite(cell) || cell.x <= 0.0 || cell.y <= 0.0 || cell.z <= 0.0)
        problems.push_back(keyProblem("cell", "expected metres above 0, found " + numberText(cell.x) + ", " +
                                                  numberText(cell.y) + ", " + numberText(cell.z)));
    if (n.x < 1 || n.y < 1 || n.z < 1) {
        problems.push_back(keyProblem("points", "expected at least 1 in each direction, found " +
                                                    std::to_string(n.x) + ", " + std::to_string(n.y) + ", " +
                                                    std::to_string(n.z)));
        return problems;
    }
    const std::size_t steps = std::max<std::size_t>(1, grid.times.size());
    std::string shape =
        "3 x " + std::to_string(n.x) + " x " + std::to_string(n.y) + " x " + std::to_string(n.z) + " points";
    if (!grid.times.empty())
        shape += " x " + std::to_string(steps) + " times";
    checkValues(grid.values, 3.0 * n.x * n.y * n.z * static_cast<double>(steps), shape, problems);
    const std::vector<float>& deviations = grid.deviations;
    if (!deviations.empty() && 3 * deviations.size() != grid.values.size())
        problems.push_back(keyProblem("deviations", "expected one number for each point and time, found " +
                                                        std::to_string(deviations.size())));
    if (!std::all_of(deviations.begin(), deviations.end(),
                     [](float each) { return each >= 0.0f && std::isfinite(each); }))
        problems.push_back(keyProblem("deviations", "expected finite m/s of at least 0"));
    if (problems.empty() && !grid.heights.empty())
        checkHeights(grid, problems);
    if (problems.empty())
        checkRoughness(grid, problems);
    return problems;
}

Result<std::shared_ptr<const GridWind>> GridWind::create(Grid grid) {
    Diagnostics problems = check(grid);
    if (!problems.empty())
        return problems;
    return std::shared_ptr<const GridWind>(new GridWind(std::move(grid)));
}

Result<WindFieldPtr> GridWind::fromForestWind(int width, int length, std::vector<float> values,
                                              const glm::dvec3& origin) {
    Diagnostics problems;
    if (width < 1)
        problems.push_back(keyProblem("width", "expected at least 1 cell, found " + std::to_string(width)));
    if (length < 1)
        problems.push_back(keyProblem("length", "expected at least 1 cell, found " + std::to_string(length)));
    if (!allFinite(origin))
        problems.push_back(keyProblem("origin", "expected finite metres"));
    if (problems.empty())
        checkValues(values, 3.0 * width * length,
                    "width " + std::to_string(width) + " x length " + std::to_string(length) + " x 3",
                    problems);
    if (!problems.empty())
        return problems;
    return WindFieldPtr(
        std::make_shared<ThesisWind>(ThesisWind::Array{width, length, std::move(values), origin}));
}

std::optional<LogProfile> GridWind::profile() const {
    if (!(_grid.roughness > 0.0))
        return {};
    const bool isAtTen = _grid.points.z > 1 && _grid.roughness < 10.0;
    return LogProfile{isAtTen ? 10.0 : lowestLayer(_grid), _grid.roughness};
}

glm::vec3 GridWind::velocity(const WindPlace& place, double time) const {
    return Sampler(_grid, time).at(place);
}

void GridWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const Sampler sampler(_grid, time);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = sampler.at(places[i]);
}

} // namespace osgTreeWind
