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
/// Bare twigs stand for many finer ones, among leaves for themselves.
constexpr float widthInLeaf = 0.75f;

std::vector<glm::vec2> polygonOf(const LeafOutline& outline, const LeafBlade& blade) {
    std::vector<glm::vec2> polygon;
    for (const glm::vec2& p : outline)
        polygon.emplace_back(blade.point(p));
    for (std::size_t i = outline.size(); i-- > 0;)
        polygon.emplace_back(blade.point({-outline[i].x, outline[i].y}));
    return polygon;
}

} // namespace

glm::vec3 LeafBlade::point(const glm::vec2& outline) const {
    const glm::vec2 along{glm::sin(lean), glm::cos(lean)}, side{along.y, -along.x};
    const glm::vec2 way{glm::sin(toward), glm::cos(toward)};
    const glm::vec2 flat = length * (outline.x * side + outline.y * along);
    const float reach = glm::dot(flat, way);
    return {foot + flat + (glm::cos(tilt) - 1.0f) * reach * way, glm::sin(tilt) * reach};
}

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

void SprayCanvas::addTwigs(const std::vector<TwigPiece>& twigs) {
    const std::uint8_t brightness = byteOf(twigBrightness), hue = byteOf(twigHue);
    for (const TwigPiece& piece : twigs) {
        const glm::vec2 along = glm::normalize(piece.end - piece.foot), side{along.y, -along.x};
        const auto paint = [&](float width, std::uint8_t part) {
            const glm::vec2 foot = 0.5f * width * piece.footWidth * side,
                            end = 0.5f * width * piece.endWidth * side;
            fill({piece.foot - foot, piece.foot + foot, piece.end + end, piece.end - end},
                 [&](std::size_t i, const glm::vec2&) {
                     _parts[i] = static_cast<std::uint8_t>(_parts[i] | part);
                     _brightness[i] = brightness;
                     _hue[i] = hue;
                 });
        };
        paint(1.0f, bareTwig);
        paint(widthInLeaf, leafyTwig);
    }
}

std::vector<TwigPiece> SprayCanvas::fitTwigs(std::vector<TwigPiece> twigs, float coverage) {
    for (int step = 0; step < 4; ++step) {
        std::fill(_parts.begin(), _parts.end(), std::uint8_t{0});
        addTwigs(twigs);
        const auto drawn =
            std::count_if(_parts.begin(), _parts.end(), [](std::uint8_t part) { return part & bareTwig; });
        const float factor = coverage * size * size / static_cast<float>(std::max<std::ptrdiff_t>(drawn, 1));
        for (TwigPiece& piece : twigs) {
            piece.footWidth *= factor;
            piece.endWidth *= factor;
        }
    }
    std::fill(_parts.begin(), _parts.end(), std::uint8_t{0});
    addTwigs(twigs);
    return twigs;
}

void SprayCanvas::addLeaf(const LeafOutline& outline, const LeafBlade& blade) {
    const glm::vec2 along{glm::sin(blade.lean), glm::cos(blade.lean)}, side{along.y, -along.x};
    const glm::vec2 toward{glm::sin(blade.toward), glm::cos(blade.toward)};
    const float unfolded = 1.0f / glm::cos(blade.tilt) - 1.0f;
    const std::uint8_t hue = byteOf(blade.hue);
    fill(polygonOf(outline, blade), [&](std::size_t i, const glm::vec2& p) {
        glm::vec2 q = (p - blade.foot) / blade.length;
        q += unfolded * glm::dot(q, toward) * toward;
        const float u = glm::dot(q, along), v = glm::dot(q, side);
        // One half of a blade faces the light more than the other; its rib is lighter.
        const float half = v < 0.0f ? 1.06f : 0.94f;
        const float rib = glm::abs(v) < 0.02f && blade.length > 0.06f ? 1.15f : 1.0f;
        _leafSamples += (_parts[i] & (leaf | bareTwig)) == 0;
        _parts[i] = static_cast<std::uint8_t>(_parts[i] | leaf);
        const float lit = blade.brightness * half * rib * (0.84f + 0.24f * u);
        _brightness[i] = static_cast<std::uint8_t>(255.0f * glm::clamp(lit, 0.0f, 1.0f) + 0.5f);
        _hue[i] = hue;
    });
}

float SprayCanvas::freeShare(const LeafOutline& outline, const LeafBlade& blade) {
    std::size_t free = 0, all = 0;
    fill(polygonOf(outline, blade), [&](std::size_t i, const glm::vec2&) {
        ++all;
        free += (_parts[i] & leaf) == 0;
    });
    return all == 0 ? 0.0f : static_cast<float>(free) / static_cast<float>(all);
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
                twigs += _parts[at] & bareTwig ? 1.0f : 0.0f;
                if (!(_parts[at] & (leaf | leafyTwig)))
                    continue;
                any += 1.0f;
                brightness += static_cast<float>(_brightness[at]) / 255.0f;
                hue += static_cast<float>(_hue[at]) / 255.0f;
            }
            // Outside the shape the colour stays leaf-like, so that filters get no dark rim.
            texels.at(x, y) = any > 0.0f ? glm::vec4(brightness / any, hue / any, share * twigs, share * any)
                                         : glm::vec4(0.75f, 0.5f, share * twigs, 0.0f);
        }
    return texels;
}

} // namespace osgTreeWind
