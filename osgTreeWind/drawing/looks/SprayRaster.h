// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// Rasterizes polygons to the samples of a card from (0, 0) to (1, 1). Rows run from the bottom up.
class SprayRaster {
public:
    static constexpr int pixels = 512, samples = 2; ///< Per side of the card; per side of a pixel.
    static constexpr int size = pixels * samples;

    /// The samples [first, end) of a row.
    struct Span {
        int row, first, end;
    };

    /// The samples inside a polygon (even-odd rule), from the bottom up. Valid until the next call.
    const std::vector<Span>& spans(const std::vector<glm::vec2>& polygon);

    /// The first sample of a span in the samples of a card.
    template <typename Value>
    static Value* at(std::vector<Value>& card, const Span& span) {
        return card.data() + span.row * size + span.first;
    }

private:
    void addCrossings(const glm::vec2& a, const glm::vec2& b, int low, int high);

    std::vector<std::vector<float>> _crossings{size}; ///< By row: intersections with edges of the polygon.
    std::vector<Span> _spans;
};

} // namespace osgTreeWind
