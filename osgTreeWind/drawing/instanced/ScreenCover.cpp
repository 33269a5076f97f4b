// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ScreenCover.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace osgTreeWind {
namespace {

/// Share of a cell from `cell` to `cell + 1` between two places.
float within(int cell, float from, float to) {
    return std::min(to, static_cast<float>(cell + 1)) - std::max(from, static_cast<float>(cell));
}

/// A whole number of cells on the screen.
int onScreen(float cells, int most) {
    return static_cast<int>(std::clamp(cells, 0.0f, static_cast<float>(most)));
}

/// Row or column of a picture's grid at a place, [0, 1).
int part(float place) {
    return std::clamp(static_cast<int>(place * PictureCover::side), 0, PictureCover::side - 1);
}

float columnAt(float x) {
    return 0.5f * ScreenCover::columns * (x + 1.0f);
}
float rowAt(float y) {
    return 0.5f * ScreenCover::rows * (y + 1.0f);
}

/// Calls visit(cell, how much of it the picture hides) for each cell of the screen that it touches.
template <typename Visit>
void forEachCell(const ScreenCover::Picture& picture, Visit visit) {
    if (!picture.cover)
        return;
    const float bottom = rowAt(picture.low.y()), top = rowAt(picture.high.y());
    const float width = ScreenCover::columns * picture.halfWidth;
    const int last = onScreen(std::ceil(top), ScreenCover::rows);
    for (int y = onScreen(std::floor(bottom), ScreenCover::rows); y < last; ++y) {
        const float height = within(y, bottom, top);
        const float middle = std::max(bottom, static_cast<float>(y)) + 0.5f * height;
        const float up = (middle - bottom) / (top - bottom);
        const float left =
            columnAt(picture.low.x() + up * (picture.high.x() - picture.low.x())) - 0.5f * width;
        const int rowPart = part(up);
        const float* const cover = picture.cover->data() + rowPart * PictureCover::side;
        const int end = onScreen(std::ceil(left + width), ScreenCover::columns);
        for (int x = onScreen(std::floor(left), ScreenCover::columns); x < end; ++x) {
            const float across = within(x, left, left + width);
            const float place = std::max(left, static_cast<float>(x)) + 0.5f * across - left;
            visit(static_cast<std::size_t>(y * ScreenCover::columns + x), rowPart,
                  height * across * cover[part(place / width)]);
        }
    }
}

} // namespace

float ScreenCover::clearness(const Picture& picture) const {
    std::array<float, PictureCover::side> shown{}, clear{};
    bool touched = false;
    forEachCell(picture, [&](std::size_t cell, int part, float hides) {
        const float shows = hides * _shows[cell];
        shown[static_cast<std::size_t>(part)] += shows;
        clear[static_cast<std::size_t>(part)] += shows * _shows[cell];
        touched = touched || hides > 0.0f;
    });
    if (!touched)
        return 1.0f;
    float clearest = 0.0f;
    for (std::size_t part = 0; part < shown.size(); ++part)
        if (shown[part] > 0.0f)
            clearest = std::max(clearest, clear[part] / shown[part]);
    return clearest;
}

bool ScreenCover::hides(const Picture& picture, float share) const {
    float shown = 0.0f, hidden = 0.0f, most = 0.0f;
    forEachCell(picture, [&](std::size_t cell, int, float hides) {
        shown += hides * _shows[cell];
        hidden += hides;
        most = std::max(most, hides > 0.0f ? _shows[cell] : 0.0f);
    });
    return hidden > 0.0f && most < hardly && shown < share * columns * rows;
}

float ScreenCover::leastShown(const osg::Vec2& low, const osg::Vec2& high) const {
    const int left = onScreen(std::floor(columnAt(low.x())), columns),
              right = onScreen(std::ceil(columnAt(high.x())), columns),
              bottom = onScreen(std::floor(rowAt(low.y())), rows),
              top = onScreen(std::ceil(rowAt(high.y())), rows);
    float least = 1.0f;
    for (int row = bottom; row < top; ++row)
        for (int column = left; column < right; ++column)
            least = std::min(least, _shows[static_cast<std::size_t>(row * columns + column)]);
    return least;
}

void ScreenCover::add(const Picture& picture) {
    forEachCell(picture, [&](std::size_t cell, int, float hides) { _shows[cell] *= 1.0f - hides; });
}

} // namespace osgTreeWind
