// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BarkRelief.h>

#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int width = 256, height = 512;

/// @param at texture coordinates: u around, v along, [0, 1]. @param grid columns and rows.
float noise(const glm::vec2& at, const glm::ivec2& grid, unsigned stream) {
    return valueNoise(at * glm::vec2(grid), grid, stream);
}

/// The nearest of random points, one in each cell of a grid (Worley 1996).
struct Plate {
    float edge; ///< Distance from the edge to the next plate, in cells.
    float own;  ///< Random number of the plate, [0, 1).
};
Plate plateAt(const glm::vec2& at, const glm::ivec2& grid, unsigned stream) {
    const glm::vec2 place = at * glm::vec2(grid), cell = glm::floor(place);
    float nearest = 9.0f, next = 9.0f, own = 0.0f;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            const glm::ivec2 near = glm::ivec2(cell) + glm::ivec2(i, j);
            const glm::vec2 point =
                glm::vec2(near) + glm::vec2(randomAt(near, grid, stream), randomAt(near, grid, stream + 1));
            const float away = glm::distance(place, point);
            next = glm::min(next, glm::max(away, nearest));
            if (away < nearest) {
                nearest = away;
                own = randomAt(near, grid, stream + 2);
            }
        }
    return {next - nearest, own};
}

/// Place moved around the stem at random.
glm::vec2 sidewaysWarped(const glm::vec2& at) {
    return at + glm::vec2(0.06f * (noise(at, {4, 8}, 2) - 0.5f), 0.0f);
}

// Each bark returns brightness, height and hue. @param grain the finest noise, [-0.5, 0.5].

/// Ridges along the stem that wander, meet, part and are cracked across.
glm::vec3 furrowedBark(const glm::vec2& at, float grain) {
    const float wander =
        1.5f * noise(at, {4, 5}, 3) + 0.9f * noise(at, {12, 9}, 4) + 0.3f * noise(at, {30, 40}, 7);
    const float ridge = glm::abs(glm::sin(glm::pi<float>() * (14.0f * at.x + wander)));
    const float crack = glm::smoothstep(0.0f, 0.10f, glm::abs(noise(sidewaysWarped(at), {14, 30}, 5) - 0.5f));
    const float rise = glm::smoothstep(0.05f, 0.65f, ridge) * (0.7f + 0.3f * crack);
    const float fibre = noise(at, {90, 40}, 8) - 0.5f;
    return {0.50f + 0.30f * rise + 0.14f * grain + 0.12f * fibre,
            0.85f * rise + 0.08f * grain + 0.07f * fibre,
            0.45f + 0.15f * rise + 0.25f * (noise(at, {4, 7}, 6) - 0.5f)};
}

/// Long plates between fissures, each of thin layers that flake off.
glm::vec3 platedBark(const glm::vec2& at, float grain) {
    const glm::vec2 rough = 0.035f * glm::vec2(noise(at, {14, 20}, 3) - 0.5f, noise(at, {14, 20}, 7) - 0.5f) +
                            0.012f * glm::vec2(noise(at, {40, 60}, 8) - 0.5f, noise(at, {40, 60}, 9) - 0.5f);
    const Plate plate = plateAt(sidewaysWarped(at) + rough, {9, 6}, 4),
                flake = plateAt(at + 2.0f * rough, {16, 20}, 10);
    const float rise = glm::smoothstep(0.02f, 0.17f, plate.edge),
                layer = std::floor(3.0f * flake.own + 1.2f * plate.edge) / 4.0f;
    const float lip = glm::smoothstep(0.0f, 0.05f, flake.edge);
    return {0.40f + rise * (0.28f + 0.22f * layer + 0.08f * lip) + 0.14f * grain,
            0.75f * rise + 0.2f * layer + 0.08f * grain, 0.38f + rise * (0.05f + 0.4f * flake.own)};
}

/// Thin scales of a few centimetres, loose at their lower edges.
glm::vec3 scalyBark(const glm::vec2& at, float grain) {
    const glm::vec2 rough = 0.02f * glm::vec2(noise(at, {20, 30}, 3) - 0.5f, noise(at, {20, 30}, 7) - 0.5f);
    const Plate scale = plateAt(at + rough, {17, 22}, 4), older = plateAt(at - rough, {9, 11}, 10);
    const float edge = glm::smoothstep(0.0f, 0.12f, scale.edge);
    return {0.56f + 0.10f * edge + 0.16f * scale.own + 0.10f * older.own + 0.14f * grain,
            0.45f + 0.14f * edge + 0.22f * scale.own + 0.12f * older.own + 0.08f * grain,
            0.40f + 0.25f * scale.own + 0.15f * older.own};
}

glm::vec3 smoothBark(const glm::vec2& at, float grain) {
    const float cloud = noise(at, {4, 5}, 3), wrinkle = noise(at, {5, 40}, 4);
    const float fold = glm::smoothstep(0.72f, 0.95f, wrinkle);
    return {0.72f + 0.18f * cloud - 0.12f * fold + 0.06f * grain, 0.6f - 0.1f * fold + 0.05f * cloud,
            0.4f + 0.25f * noise(at, {3, 4}, 5)};
}

/// Lenticels in lines across, and black cracked patches.
glm::vec3 bandedBark(const glm::vec2& at, float grain) {
    const float line = noise(at, {5, 44}, 3) * glm::smoothstep(0.3f, 0.6f, noise(at, {2, 11}, 4));
    const float band = glm::smoothstep(0.52f, 0.62f, line);
    const float patch = glm::smoothstep(0.64f, 0.76f, noise(sidewaysWarped(at), {3, 6}, 10) + 0.12f * grain);
    const float dark = glm::max(0.75f * band, patch);
    return {glm::mix(0.95f + 0.06f * grain, 0.14f + 0.1f * grain, dark),
            0.6f - 0.2f * band - patch * (0.3f + grain), 0.5f + 0.1f * noise(at, {3, 5}, 6)};
}

glm::vec3 flakingBark(const glm::vec2& at, float grain) {
    const Plate old =
        plateAt(at + 0.04f * glm::vec2(noise(at, {9, 18}, 3), noise(at, {9, 18}, 4)), {3, 5}, 5);
    const Plate young =
        plateAt(at + 0.03f * glm::vec2(noise(at, {9, 18}, 6), noise(at, {9, 18}, 7)), {4, 7}, 8);
    const float fresh = young.own < 0.4f ? glm::smoothstep(0.0f, 0.06f, young.edge) : 0.0f;
    const float shade = old.own < 0.35f ? 0.48f : old.own < 0.7f ? 0.62f : 0.75f;
    return {glm::mix(shade, 0.98f, fresh) + 0.06f * grain, 0.6f - 0.35f * fresh + 0.2f * old.own,
            glm::mix(0.35f + 0.4f * old.own, 0.85f, fresh)};
}

glm::vec3 ringedBark(const glm::vec2& at, float grain) {
    const float along = 12.0f * (at.y + 0.01f * noise(at, {4, 12}, 3));
    const float part = along - std::floor(along);
    const float scar = 1.0f - glm::smoothstep(0.0f, 0.16f, glm::min(part, 1.0f - part));
    const float fibre = noise(at, {40, 12}, 4) - 0.5f;
    return {0.76f - 0.3f * scar + 0.2f * fibre + 0.1f * grain,
            0.7f * (1.0f - scar) + 0.3f * part + 0.1f * fibre, 0.5f + 0.1f * fibre};
}

constexpr glm::vec3 (*barks[])(const glm::vec2&, float) = {furrowedBark, platedBark, smoothBark, bandedBark,
                                                           flakingBark,  ringedBark, scalyBark}; // by form

} // namespace

osg::ref_ptr<osg::Image> paintBark(BarkForm form) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / glm::vec2(width, height);
            const glm::vec3 bark = barks[static_cast<std::size_t>(form)](at, noise(at, {48, 96}, 1) - 0.5f);
            for (int channel = 0; channel < 3; ++channel)
                image->data(x, y)[channel] = byteOf(bark[channel]);
        }
    return image;
}

} // namespace osgTreeWind
