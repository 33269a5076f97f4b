// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayCanvas.h>

#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

// In leaf, twigs are dark and brownish between the leaves.
constexpr float twigBrightness = 0.4f, twigHue = 0.75f;

} // namespace

SprayCanvas::SprayCanvas() : _brightness(size * size), _hue(size * size), _parts(size * size) {}

/// Calls `paint(index, point)` for every sample within a polygon (even-odd).
template <typename Paint>
void SprayCanvas::fill(const std::vector<glm::vec2>& polygon, Paint paint) {
    float low = 1.0f, high = 0.0f;
    for (const glm::vec2& p : polygon) {
        low = glm::min(low, p.y);
        high = glm::max(high, p.y);
    }
    const auto sample = [](float x) { return glm::clamp(static_cast<int>(std::lround(x * size)), 0, size); };
    const int end = sample(high);
    for (int row = sample(low); row < end; ++row) {
        const float y = (static_cast<float>(row) + 0.5f) / size;
        _crossings.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if ((a.y <= y) != (b.y <= y))
                _crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        std::sort(_crossings.begin(), _crossings.end());
        for (std::size_t i = 0; i + 1 < _crossings.size(); i += 2) {
            const int last = sample(_crossings[i + 1]);
            for (int x = sample(_crossings[i]); x < last; ++x)
                paint(static_cast<std::size_t>(row * size + x),
                      glm::vec2((static_cast<float>(x) + 0.5f) / size, y));
        }
    }
}

void SprayCanvas::drawTwigs(const std::vector<TwigPiece>& twigs) {
    for (const TwigPiece& piece : twigs) {
        const glm::vec2 along = glm::normalize(piece.end - piece.foot), side{along.y, -along.x};
        const glm::vec2 foot = 0.5f * piece.footWidth * side, end = 0.5f * piece.endWidth * side;
        fill({piece.foot - foot, piece.foot + foot, piece.end + end, piece.end - end},
             [&](std::size_t i, const glm::vec2&) {
                 _parts[i] = twig;
                 _brightness[i] = byteOf(twigBrightness);
                 _hue[i] = byteOf(twigHue);
             });
    }
}

void SprayCanvas::addTwigs(std::vector<TwigPiece> twigs, float coverage) {
    for (int step = 0; step < 4; ++step) {
        std::fill(_parts.begin(), _parts.end(), std::uint8_t{0});
        drawTwigs(twigs);
        const auto drawn = std::count(_parts.begin(), _parts.end(), twig);
        const float factor = coverage * size * size / static_cast<float>(std::max<std::ptrdiff_t>(drawn, 1));
        for (TwigPiece& piece : twigs) {
            piece.footWidth *= factor;
            piece.endWidth *= factor;
        }
    }
    std::fill(_parts.begin(), _parts.end(), std::uint8_t{0});
    drawTwigs(twigs);
}

void SprayCanvas::addLeaf(const LeafOutline& outline, const LeafBlade& blade) {
    const glm::vec2 along{glm::sin(blade.lean), glm::cos(blade.lean)}, side{along.y, -along.x};
    std::vector<glm::vec2> polygon;
    for (const glm::vec2& p : outline)
        polygon.push_back(blade.foot + blade.length * (p.x * side + p.y * along));
    for (std::size_t i = outline.size(); i-- > 0;)
        polygon.push_back(blade.foot + blade.length * (outline[i].y * along - outline[i].x * side));
    const std::uint8_t hue = byteOf(blade.hue);
    fill(polygon, [&](std::size_t i, const glm::vec2& p) {
        const float u = glm::dot(p - blade.foot, along) / blade.length,
                    v = glm::dot(p - blade.foot, side) / blade.length;
        // One half of a blade faces the light more than the other; its rib is lighter.
        const float half = v < 0.0f ? 1.06f : 0.94f;
        const float rib = glm::abs(v) < 0.02f && blade.length > 0.06f ? 1.15f : 1.0f;
        _parts[i] = static_cast<std::uint8_t>(_parts[i] | leaf);
        _brightness[i] = byteOf(blade.brightness * half * rib * (0.84f + 0.24f * u));
        _hue[i] = hue;
    });
}

LeafTexels SprayCanvas::texels() const {
    LeafTexels texels(pixels);
    constexpr float share = 1.0f / (samples * samples);
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            float brightness = 0.0f, hue = 0.0f, twigs = 0.0f, any = 0.0f;
            for (int i = 0; i < samples * samples; ++i) {
                const auto at =
                    static_cast<std::size_t>((y * samples + i / samples) * size + x * samples + i % samples);
                if (!_parts[at])
                    continue;
                any += 1.0f;
                brightness += static_cast<float>(_brightness[at]) / 255.0f;
                hue += static_cast<float>(_hue[at]) / 255.0f;
                twigs += _parts[at] & twig ? 1.0f : 0.0f;
            }
            // Outside the shape the colour stays leaf-like, so that filters get no dark rim.
            texels.at(x, y) = any > 0.0f ? glm::vec4(brightness / any, hue / any, share * twigs, share * any)
                                         : glm::vec4(0.75f, 0.5f, 0.0f, 0.0f);
        }
    return texels;
}

} // namespace osgTreeWind
