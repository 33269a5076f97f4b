// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Arrows.h>

#include <osgTreeWind/base/Viridis.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace osgTreeWind;

constexpr int longSide = 960, shortSide = 240; // pixels
constexpr int arrowCell = 32;                  // distance between arrows, pixels

struct Canvas {
    osg::ref_ptr<osg::Image> image = new osg::Image; ///< Lowest row first.

    explicit Canvas(const glm::ivec2& size) {
        image->allocateImage(size.x, size.y, 1, GL_RGB, GL_UNSIGNED_BYTE);
    }

    void set(int x, int y, const glm::vec3& colour) {
        if (x < 0 || y < 0 || x >= image->s() || y >= image->t())
            return;
        for (int i = 0; i < 3; ++i)
            image->data(x, y)[i] = static_cast<unsigned char>(std::lround(255.0f * colour[i]));
    }

    void line(const glm::vec2& from, const glm::vec2& to, const glm::vec3& colour) {
        const int steps = static_cast<int>(std::ceil(2.0f * glm::length(to - from)));
        for (int i = 0; i <= steps; ++i) {
            const glm::vec2 at =
                glm::mix(from, to, steps > 0 ? static_cast<float>(i) / static_cast<float>(steps) : 0.0f);
            set(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), colour);
        }
    }

    /// Draws an arrow around its middle, or a dot for a length of 0.
    void arrow(const glm::vec2& middle, const glm::vec2& along, const glm::vec3& colour) {
        const glm::vec2 tip = middle + 0.5f * along, side(-along.y, along.x);
        line(middle - 0.5f * along, tip, colour);
        line(tip, tip - 0.3f * along + 0.18f * side, colour);
        line(tip, tip - 0.3f * along - 0.18f * side, colour);
    }
};

} // namespace

osg::ref_ptr<osg::Image> drawArrows(const WindField& wind, const glm::dvec3& low, const glm::dvec3& high,
                                    double fastest) {
    glm::dvec2 extent = glm::dvec2(high - low);
    const double longest = std::max({extent.x, extent.y, 1.0});
    const glm::ivec2 size = glm::clamp(glm::ivec2(glm::round(extent / longest * double(longSide))),
                                       glm::ivec2(shortSide), glm::ivec2(longSide));
    Canvas canvas(size);
    const auto windAt = [&](const glm::dvec2& pixel) {
        const glm::dvec2 share = pixel / glm::dvec2(size);
        return wind.velocity(glm::vec3(low + glm::dvec3(share * extent, 0.0)), 0.0);
    };
    const double scale = 1.0 / std::max(fastest, 1e-9);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            canvas.set(x, y, viridis(glm::length(windAt({x + 0.5, y + 0.5})) * scale));
    for (int y = arrowCell / 2; y < size.y; y += arrowCell)
        for (int x = arrowCell / 2; x < size.x; x += arrowCell) {
            const glm::vec3 velocity = windAt({x, y});
            const bool bright = glm::length(velocity) * scale > 0.6;
            canvas.arrow({x, y}, glm::vec2(velocity) * static_cast<float>(0.9 * arrowCell * scale),
                         glm::vec3(bright ? 0.0f : 1.0f));
        }
    return canvas.image;
}
