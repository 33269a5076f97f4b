// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayCoverage.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

constexpr float cardSamples = SprayRaster::size * SprayRaster::size;

} // namespace

std::vector<TwigPiece> SprayCoverage::fitTwigs(std::vector<TwigPiece> twigs, float coverage) {
    for (int step = 0; step < 4; ++step) {
        drawTwigs(twigs);
        const auto drawn = std::count(_parts.begin(), _parts.end(), twig);
        const float factor = coverage * cardSamples / static_cast<float>(std::max<std::ptrdiff_t>(drawn, 1));
        for (TwigPiece& piece : twigs) {
            piece.footWidth *= factor;
            piece.endWidth *= factor;
        }
    }
    drawTwigs(twigs);
    return twigs;
}

void SprayCoverage::drawTwigs(const std::vector<TwigPiece>& twigs) {
    std::fill(_parts.begin(), _parts.end(), std::uint8_t{0});
    for (const TwigPiece& piece : twigs)
        for (const SprayRaster::Span& span : _raster.spans(piece.polygon()))
            std::fill_n(SprayRaster::at(_parts, span), span.end - span.first, twig);
}

void SprayCoverage::addLeaf(const LeafOutline& outline, const LeafBlade& blade) {
    for (const SprayRaster::Span& span : _raster.spans(blade.polygon(outline))) {
        std::uint8_t* parts = SprayRaster::at(_parts, span);
        const int count = span.end - span.first;
        _leafSamples += static_cast<std::size_t>(std::count(parts, parts + count, std::uint8_t{0}));
        for (int i = 0; i < count; ++i)
            parts[i] = static_cast<std::uint8_t>(parts[i] | leaf);
    }
}

float SprayCoverage::freeShare(const LeafOutline& outline, const LeafBlade& blade) {
    std::ptrdiff_t free = 0, all = 0;
    for (const SprayRaster::Span& span : _raster.spans(blade.polygon(outline))) {
        const std::uint8_t* parts = SprayRaster::at(_parts, span);
        const int count = span.end - span.first;
        all += count;
        free += std::count_if(parts, parts + count, [](std::uint8_t part) { return (part & leaf) == 0; });
    }
    return all == 0 ? 0.0f : static_cast<float>(free) / static_cast<float>(all);
}

float SprayCoverage::leafShare() const {
    return static_cast<float>(_leafSamples) / cardSamples;
}

} // namespace osgTreeWind
