// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/portraits/Silhouette.h>

#include <osgTreeWind/drawing/looks/Parallelogram.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace osgTreeWind {

void Silhouette::draw(const glm::vec2& corner, const glm::vec2& across, const glm::vec2& along,
                      const Mask& mask) {
    visitParallelogram(corner, across, along, mask.size, _size, [&](const ParallelogramRow& row) {
        for (int x = row.first; x < row.end; ++x)
            if (mask.solid[static_cast<std::size_t>(row.cell(x))])
                _black[static_cast<std::size_t>(row.y * _size + x)] = 1;
    });
}

void Silhouette::spread(int reach, std::uint8_t value) {
    std::vector<std::uint8_t> before;
    for (const auto& [step, line] : {std::pair(1, _size), std::pair(_size, 1)}) {
        before = _black;
        for (int i = 0; i < _size; ++i) {
            int last = -2 * _size; // position of the last pixel with the value, in both passes
            const auto pass = [&, step = step, line = line](int j) {
                const auto at = static_cast<std::size_t>(i * line + j * step);
                if (before[at] == value)
                    last = j;
                if (std::abs(j - last) <= reach)
                    _black[at] = value;
            };
            for (int j = 0; j < _size; ++j)
                pass(j);
            last = 3 * _size;
            for (int j = _size; j-- > 0;)
                pass(j);
        }
    }
}

Silhouette Silhouette::outline(int side) const {
    Silhouette closed = *this;
    closed.spread(side / 2, 1);
    closed.spread(side / 2, 0);
    // Pixels that a flood fill from the edge does not reach are inside.
    Silhouette within(_size);
    std::fill(within._black.begin(), within._black.end(), std::uint8_t{1});
    std::vector<glm::ivec2> open;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= _size || y >= _size || closed.black(x, y) || !within.black(x, y))
            return;
        within._black[static_cast<std::size_t>(y * _size + x)] = 0;
        open.emplace_back(x, y);
    };
    for (int i = 0; i < _size; ++i)
        for (const int edge : {0, _size - 1}) {
            visit(i, edge);
            visit(edge, i);
        }
    while (!open.empty()) {
        const glm::ivec2 p = open.back();
        open.pop_back();
        visit(p.x - 1, p.y);
        visit(p.x + 1, p.y);
        visit(p.x, p.y - 1);
        visit(p.x, p.y + 1);
    }
    return within;
}

int Silhouette::cutStem() {
    std::vector<int> widths;
    int top = 0;
    for (int y = 0; y < _size; ++y) {
        const auto first = _black.begin() + y * _size, end = first + _size;
        const auto left = std::find(first, end, std::uint8_t{1});
        const auto right =
            std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(left), std::uint8_t{1});
        widths.push_back(static_cast<int>(right.base() - left));
        top = widths.back() > 0 ? y : top;
    }
    const int widest = *std::max_element(widths.begin(), widths.end());
    const auto foot =
        std::find_if(widths.begin(), widths.end(), [&](int width) { return 10 * width > 3 * widest; });
    const auto rows = foot - widths.begin();
    std::fill_n(_black.begin(), rows * _size, std::uint8_t{0});
    return top + 1 - static_cast<int>(rows);
}

Silhouette Silhouette::shrunk(int pixels, float share) const {
    const int least = static_cast<int>(std::ceil(share * static_cast<float>(pixels * pixels)));
    Silhouette small(_size / pixels);
    for (int y = 0; y < small._size; ++y)
        for (int x = 0; x < small._size; ++x) {
            int count = 0;
            for (int i = 0; i < pixels * pixels; ++i)
                count += black(pixels * x + i % pixels, pixels * y + i / pixels);
            small._black[static_cast<std::size_t>(y * small._size + x)] = count >= least;
        }
    return small;
}

std::size_t Silhouette::count() const {
    return static_cast<std::size_t>(std::count(_black.begin(), _black.end(), std::uint8_t{1}));
}

std::size_t Silhouette::common(const Silhouette& other) const {
    std::size_t both = 0;
    for (std::size_t i = 0; i < _black.size(); ++i)
        both += _black[i] & other._black[i];
    return both;
}

} // namespace osgTreeWind
