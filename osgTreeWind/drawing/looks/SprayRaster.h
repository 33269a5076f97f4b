// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// The samples of a card whose corners are (0, 0) and (1, 1): rows from the bottom up.
class SprayRaster {
public:
    static constexpr int pixels = 256, samples = 3; ///< Of the card; of a pixel, in rows and columns.
    static constexpr int size = pixels * samples;

    /// A stretch of samples of a row: [first, end).
    struct Span {
        int row, first, end;
    };

    /// The samples within a polygon (even-odd), from the bottom up; until the next call.
    const std::vector<Span>& spans(const std::vector<glm::vec2>& polygon);

    /// Of the samples of a card, those of a span.
    template <typename Value>
    static Value* at(std::vector<Value>& card, const Span& span) {
        return card.data() + span.row * size + span.first;
    }

private:
    void cross(const glm::vec2& a, const glm::vec2& b, int low, int high);

    std::vector<std::vector<float>> _crossings{size}; ///< By row: where edges of the polygon meet it.
    std::vector<Span> _spans;
};

} // namespace osgTreeWind
