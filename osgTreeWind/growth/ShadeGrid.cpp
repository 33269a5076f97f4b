// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/ShadeGrid.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

/// A direction from which light comes: cells sideways for each cell up.
struct SkyDirection {
    int x, y;
    int steepness; ///< 0 from the zenith, 1 from halfway up, 2 from low.
    float share;   ///< Share of an overcast sky's light on leaves of all inclinations.
};
constexpr std::array<SkyDirection, 17> skyDirections = {{
    {0, 0, 0, 0.16f},
    {1, 0, 1, 0.06f},
    {-1, 0, 1, 0.06f},
    {0, 1, 1, 0.06f},
    {0, -1, 1, 0.06f},
    {1, 1, 1, 0.05f},
    {-1, 1, 1, 0.05f},
    {1, -1, 1, 0.05f},
    {-1, -1, 1, 0.05f},
    {2, 0, 2, 0.055f},
    {-2, 0, 2, 0.055f},
    {0, 2, 2, 0.055f},
    {0, -2, 2, 0.055f},
    {2, 2, 2, 0.045f},
    {-2, 2, 2, 0.045f},
    {2, -2, 2, 0.045f},
    {-2, -2, 2, 0.045f},
}};
/// Path length through a layer in cells, by steepness.
constexpr std::array<float, 3> layerPath = {1.0f, 1.57f, 2.6f};
/// Extinction by leaves of all inclinations and the twigs among them / leaf area.
constexpr float extinction = 1.0f;
/// Leaf area index of a closed stand.
constexpr float closedCanopyLeafArea = 1.75f;

/// Approximates exp(-x), with the same result on every machine.
float transmittance(float x) {
    return 1.0f / (1.0f + x + 0.5f * x * x);
}

/// Cover of neighbours in a direction: 0 towards the open side, 1 elsewhere.
float neighbourCover(const GrowthSite& site, const glm::vec2& heading) {
    if (!site.openSide)
        return 1.0f;
    const glm::vec2 open(math::cos(*site.openSide), math::sin(*site.openSide));
    return 1.0f -
           glm::smoothstep(0.0f, 0.5f, glm::dot(heading, open) / std::max(glm::length(heading), 1e-6f));
}

} // namespace

void ShadeGrid::reset(const glm::vec3& lowest, const glm::vec3& highest) {
    const glm::vec3 first = glm::floor(lowest / _cellSize) - 2.0f;
    _size = glm::max(glm::ivec3(glm::floor(highest / _cellSize) - first) + 3, glm::ivec3(2));
    _lowest = (first + 0.5f) * _cellSize;
    const std::size_t layer = static_cast<std::size_t>(_size.x) * static_cast<std::size_t>(_size.y);
    _leaves.assign(layer * static_cast<std::size_t>(_size.z), 0.0f);
    _light.assign(_leaves.size(), 1.0f);
    _neighbourLeaves.assign(static_cast<std::size_t>(_size.z), 0.0f);
    _site = {};
}

ShadeGrid::GridPosition ShadeGrid::gridPosition(const glm::vec3& place) const {
    const glm::vec3 at =
        glm::clamp((place - _lowest) / _cellSize, glm::vec3(0.0f), glm::vec3(_size) - 1.001f);
    const glm::vec3 whole = glm::floor(at);
    const auto x = static_cast<std::size_t>(whole.x), y = static_cast<std::size_t>(whole.y);
    const auto z = static_cast<std::size_t>(whole.z);
    return {(z * static_cast<std::size_t>(_size.y) + y) * static_cast<std::size_t>(_size.x) + x, at - whole};
}

void ShadeGrid::addLeaves(const glm::vec3& place, float area) {
    const GridPosition c = gridPosition(place);
    const std::size_t row = static_cast<std::size_t>(_size.x),
                      layer = row * static_cast<std::size_t>(_size.y);
    const float above = area * c.fraction.z, below = area - above;
    const float a = below * (1.0f - c.fraction.y), b = below * c.fraction.y;
    const float d = above * (1.0f - c.fraction.y), e = above * c.fraction.y;
    float* box = &_leaves[c.index];
    const float right = c.fraction.x, left = 1.0f - c.fraction.x;
    box[0] += left * a, box[1] += right * a;
    box[row] += left * b, box[row + 1] += right * b;
    box[layer] += left * d, box[layer + 1] += right * d;
    box[layer + row] += left * e, box[layer + row + 1] += right * e;
}

void ShadeGrid::addNeighbours(const GrowthSite& site, const glm::vec2& tree, float height) {
    _site = site;
    if (site.shade <= 0.0f)
        return;
    const float density = site.shade * closedCanopyLeafArea / std::max(0.55f * height, 1.0f);
    float* box = _leaves.data();
    for (int k = 0; k < _size.z; ++k) {
        const float z = _lowest.z + static_cast<float>(k) * _cellSize;
        const float inCrowns = glm::smoothstep(0.35f * height, 0.55f * height, z) *
                               (1.0f - glm::smoothstep(0.85f * height, height, z));
        const float leaves = density * inCrowns * _cellSize * _cellSize * _cellSize;
        _neighbourLeaves[static_cast<std::size_t>(k)] = leaves;
        // Crowns are domes, so the gaps between them widen upwards.
        const float gap = 0.45f + 0.25f * glm::smoothstep(0.45f * height, height, z);
        for (int j = 0; j < _size.y; ++j)
            for (int i = 0; i < _size.x; ++i, ++box) {
                const glm::vec2 from = glm::vec2(_lowest) + _cellSize * glm::vec2(i, j) - tree;
                const float there = glm::smoothstep(gap, gap + 0.3f, glm::length(from) / site.distance);
                if (leaves > 0.0f && there > 0.0f)
                    *box += leaves * there * neighbourCover(site, from);
            }
    }
}

void ShadeGrid::computeLight() {
    const std::size_t size = rowStride() * (static_cast<std::size_t>(_size.y) + 4);
    for (std::vector<float>& rays : _rays)
        rays.assign(size, 1.0f);
    for (std::vector<float>& through : _transmittance)
        through.assign(size, 1.0f);
    _nextRays.assign(size, 1.0f);
    _inflow.fill(1.0f);
    for (int layer = _size.z - 1; layer >= 0; --layer) {
        sumLight(layer);
        propagateRays(layer);
    }
}

/// Sums the light at mid-height of a layer, and computes the transmittance of the layer.
void ShadeGrid::sumLight(int layer) {
    const float thickness = extinction / (_cellSize * _cellSize);
    const std::size_t columns = static_cast<std::size_t>(_size.x), rows = static_cast<std::size_t>(_size.y);
    std::size_t box = static_cast<std::size_t>(layer) * rows * columns;
    for (std::size_t j = 0; j < rows; ++j) {
        const std::size_t start = (j + 2) * rowStride() + 2;
        for (std::size_t i = 0; i < columns; ++i, ++box) {
            const float x = thickness * _leaves[box];
            std::array<float, 3> halfway{};
            for (std::size_t s = 0; s < 3; ++s) {
                _transmittance[s][start + i] = transmittance(layerPath[s] * x);
                halfway[s] = transmittance(0.5f * layerPath[s] * x);
            }
            float sum = 0.0f;
            for (std::size_t d = 0; d < skyDirections.size(); ++d)
                sum += skyDirections[d].share *
                       halfway[static_cast<std::size_t>(skyDirections[d].steepness)] * _rays[d][start + i];
            _light[box] = sum;
        }
    }
}

/// Moves the rays to the layer below, sideways by their direction. New rays enter at the sides.
void ShadeGrid::propagateRays(int layer) {
    const float outside =
        extinction * _neighbourLeaves[static_cast<std::size_t>(layer)] / (_cellSize * _cellSize);
    for (std::size_t d = 0; d < skyDirections.size(); ++d) {
        const SkyDirection& part = skyDirections[d];
        const auto steepness = static_cast<std::size_t>(part.steepness);
        if (outside > 0.0f && part.steepness > 0)
            _inflow[d] *= transmittance(layerPath[steepness] * outside *
                                        neighbourCover(_site, glm::vec2(part.x, part.y)));
        else if (outside > 0.0f)
            _inflow[d] *= transmittance(outside);
        std::fill(_nextRays.begin(), _nextRays.end(), _inflow[d]);
        const float* through = _transmittance[steepness].data();
        const float* from = _rays[d].data();
        for (int j = 0; j < _size.y; ++j) {
            const int y = j + part.y;
            if (y < 0 || y >= _size.y)
                continue;
            const int first = std::max(0, -part.x), last = std::min(_size.x, _size.x - part.x);
            const std::size_t to = static_cast<std::size_t>(j + 2) * rowStride() + 2;
            const std::size_t source = static_cast<std::size_t>(y + 2) * rowStride() + 2;
            float* row = &_nextRays[to];
            for (int i = first; i < last; ++i) {
                const std::size_t s = source + static_cast<std::size_t>(i + part.x);
                row[i] = from[s] * through[s];
            }
        }
        _rays[d].swap(_nextRays);
    }
}

float ShadeGrid::light(const glm::vec3& place) const {
    const GridPosition c = gridPosition(place);
    const std::size_t row = static_cast<std::size_t>(_size.x),
                      layer = row * static_cast<std::size_t>(_size.y);
    const float* box = &_light[c.index];
    const auto line = [&](const float* b) { return b[0] + c.fraction.x * (b[1] - b[0]); };
    const auto face = [&](const float* b) {
        const float near = line(b);
        return near + c.fraction.y * (line(b + row) - near);
    };
    const float below = face(box);
    return below + c.fraction.z * (face(box + layer) - below);
}

glm::vec3 ShadeGrid::lightGradient(const glm::vec3& place) const {
    const float step = _cellSize;
    glm::vec3 slope(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 aside(0.0f);
        aside[axis] = step;
        slope[axis] = light(place + aside) - light(place - aside);
    }
    slope /= 2.0f * step * (light(place) + 0.1f);
    const float length = glm::length(slope);
    return length > 1.0f ? slope / length : slope;
}

} // namespace osgTreeWind
