// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int twigs = 2, all = 3;

float mean(const LeafTexels& level, int channel) {
    double sum = 0.0;
    for (const glm::vec4& texel : level.texels)
        sum += static_cast<double>(texel[channel]);
    return static_cast<float>(sum / static_cast<double>(level.texels.size()));
}

/// Makes each texel solid, 1, or empty, 0, so that every few of them keep their mean (Floyd and Steinberg
/// 1976, to and fro).
void diffuse(LeafTexels& level, int channel) {
    const auto size = static_cast<std::size_t>(level.size);
    std::vector<float> row(size + 2), next(size + 2);
    for (int y = 0; y < level.size; ++y) {
        const int step = y % 2 == 0 ? 1 : -1;
        std::fill(next.begin(), next.end(), 0.0f);
        for (int i = 0, x = step > 0 ? 0 : level.size - 1; i < level.size; ++i, x += step) {
            glm::vec4& texel = level.at(x, y);
            const auto at = static_cast<std::size_t>(x) + 1, ahead = at + static_cast<std::size_t>(step),
                       behind = at - static_cast<std::size_t>(step);
            const float wanted = texel[channel] + row[at];
            const bool solid = wanted >= 0.5f;
            const float error = wanted - (solid ? 1.0f : 0.0f);
            texel[channel] = solid ? 1.0f : 0.0f;
            row[ahead] += 7.0f / 16.0f * error;
            next[behind] += 3.0f / 16.0f * error;
            next[at] += 5.0f / 16.0f * error;
            next[ahead] += 1.0f / 16.0f * error;
        }
        row.swap(next);
    }
}

/// Share of a level that the alpha test keeps between its texels, when empty ones are not less than `empty`.
float filteredCoverage(const LeafTexels& level, int channel, float empty) {
    constexpr int samples = 4;
    std::size_t kept = 0, taken = 0;
    for (int y = 0; y + 1 < level.size; ++y)
        for (int x = 0; x + 1 < level.size; ++x) {
            const auto at = [&](int i, int j) { return glm::max(level.at(x + i, y + j)[channel], empty); };
            const float corners[4] = {at(0, 0), at(1, 0), at(0, 1), at(1, 1)};
            for (int i = 0; i < samples * samples; ++i) {
                const int row = i / samples;
                const float u = (static_cast<float>(i % samples) + 0.5f) / samples,
                            v = (static_cast<float>(row) + 0.5f) / samples;
                kept += glm::mix(glm::mix(corners[0], corners[1], u), glm::mix(corners[2], corners[3], u),
                                 v) >= LeafTexels::alphaThreshold;
                ++taken;
            }
        }
    return taken == 0 ? mean(level, channel) : static_cast<float>(kept) / static_cast<float>(taken);
}

/// What to raise empty texels to, for filters to keep a share.
float emptyFor(const LeafTexels& level, int channel, float share) {
    float low = 0.0f, high = 0.48f;
    for (int step = 0; step < 5; ++step)
        (filteredCoverage(level, channel, 0.5f * (low + high)) < share ? low : high) = 0.5f * (low + high);
    return low;
}

} // namespace

LeafTexels halved(const LeafTexels& level) {
    LeafTexels half(level.size / 2);
    for (int y = 0; y < half.size; ++y)
        for (int x = 0; x < half.size; ++x) {
            glm::vec4 sum(0.0f), plain(0.0f);
            for (int i = 0; i < 4; ++i) {
                const glm::vec4& texel = level.at(2 * x + i % 2, 2 * y + i / 2);
                const float weight = texel.a + 1e-3f; // what is empty has no say in colours
                sum += glm::vec4(weight * texel.r, weight * texel.g, texel.b, texel.a);
                plain += glm::vec4(weight);
            }
            half.at(x, y) = {sum.r / plain.r, sum.g / plain.r, 0.25f * sum.b, 0.25f * sum.a};
        }
    return half;
}

std::vector<LeafTexels> leafMipmaps(LeafTexels level) {
    std::vector<LeafTexels> levels{level};
    const float shares[2] = {mean(level, twigs), mean(level, all)};
    while (level.size > 1) {
        level = halved(level);
        LeafTexels shown = level;
        diffuse(shown, twigs);
        diffuse(shown, all);
        const float empty[2] = {emptyFor(shown, twigs, shares[0]), emptyFor(shown, all, shares[1])};
        for (glm::vec4& texel : shown.texels) {
            texel.a = glm::max(texel.a, empty[1]);
            texel.b = glm::max(texel.b, empty[0]);
        }
        levels.push_back(std::move(shown));
    }
    levels.back().texels.front().a = 1.0f; // a card that is seen edge on, or from very far
    return levels;
}

} // namespace osgTreeWind
