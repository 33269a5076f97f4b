// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>
#include <osgTreeWind/drawing/looks/LeafOutlines.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr float twigBrightness = 0.4f, twigHue = 0.75f; // dark and brownish between the leaves

/// A canvas for painting sprays. Later pieces cover earlier ones.
class SprayCanvas {
public:
    SprayCanvas()
        : _brightness(SprayRaster::size * SprayRaster::size), _hue(_brightness.size()),
          _parts(_brightness.size()) {}

    void addTwigs(const std::vector<TwigPiece>& twigs) {
        for (const TwigPiece& piece : twigs)
            for (const SprayRaster::Span& span : _raster.spans(piece.polygon())) {
                const int count = span.end - span.first;
                std::fill_n(SprayRaster::at(_parts, span), count, twig);
                std::fill_n(SprayRaster::at(_brightness, span), count, byteOf(twigBrightness));
                std::fill_n(SprayRaster::at(_hue, span), count, byteOf(twigHue));
            }
    }

    /// @param needle whether it is a needle, whose tip is brighter: its foot is in the shade of others.
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade, bool needle) {
        const glm::vec2 shade = needle ? glm::vec2(0.55f, 0.65f) : glm::vec2(0.84f, 0.24f);
        const glm::vec2 along{math::sin(blade.lean), math::cos(blade.lean)}, side{along.y, -along.x};
        const glm::vec2 toward{math::sin(blade.toward), math::cos(blade.toward)};
        const float unfolded = 1.0f / math::cos(blade.tilt) - 1.0f;
        for (const SprayRaster::Span& span : _raster.spans(blade.polygon(outline))) {
            const int count = span.end - span.first;
            std::uint8_t* brightness = SprayRaster::at(_brightness, span);
            for (int i = 0; i < count; ++i) {
                const glm::vec2 p = (glm::vec2(span.first + i, span.row) + 0.5f) / float{SprayRaster::size};
                glm::vec2 q = (p - blade.foot) / blade.length;
                q += unfolded * glm::dot(q, toward) * toward;
                const float u = glm::dot(q, along), v = glm::dot(q, side);
                // The two halves of a blade face the light differently, and the rib is lighter.
                const float half = v < 0.0f ? 1.06f : 0.94f;
                const float rib = glm::abs(v) < 0.02f && blade.length > 0.06f ? 1.15f : 1.0f;
                const float lit = blade.brightness * half * rib * (shade.x + shade.y * u);
                brightness[i] = byteOf(lit);
            }
            std::uint8_t* parts = SprayRaster::at(_parts, span);
            for (int i = 0; i < count; ++i)
                parts[i] = static_cast<std::uint8_t>(parts[i] | leaf);
            std::fill_n(SprayRaster::at(_hue, span), count, byteOf(blade.hue));
        }
    }

    LeafTexels texels() const {
        constexpr int pixels = SprayRaster::pixels, samples = SprayRaster::samples, size = SprayRaster::size;
        LeafTexels texels(pixels);
        constexpr float share = 1.0f / (samples * samples);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                float brightness = 0.0f, hue = 0.0f, twigs = 0.0f, any = 0.0f;
                for (int i = 0; i < samples * samples; ++i) {
                    const auto at = static_cast<std::size_t>((y * samples + i / samples) * size +
                                                             x * samples + i % samples);
                    twigs += _parts[at] & twig ? 1.0f : 0.0f;
                    if (_parts[at] == 0)
                        continue;
                    any += 1.0f;
                    brightness += static_cast<float>(_brightness[at]) / 255.0f;
                    hue += static_cast<float>(_hue[at]) / 255.0f;
                }
                // Empty texels have a leaf colour, so that filtering produces no dark rim.
                texels.at(x, y) = any > 0.0f
                                      ? glm::vec4(brightness / any, hue / any, share * twigs, share * any)
                                      : glm::vec4(0.75f, 0.5f, share * twigs, 0.0f);
            }
        return texels;
    }

private:
    static constexpr std::uint8_t leaf = 1, twig = 2;

    SprayRaster _raster;
    std::vector<std::uint8_t> _brightness, _hue, _parts;
};

} // namespace

LeafTexels paintSpray(LeafForm form, const LeafSpray& spray) {
    SprayCanvas canvas;
    canvas.addTwigs(spray.twigs);
    const LeafOutline outline = leafOutline(form);
    for (const LeafBlade& blade : spray.blades)
        canvas.addLeaf(outline, blade, isNeedles(form));
    return canvas.texels();
}

} // namespace osgTreeWind
