// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BarkRelief.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr int width = 256, height = 512;

/// @param at texture coordinates: u around, v along, [0, 1]. @param grid columns and rows.
float noise(const glm::vec2& at, const glm::ivec2& grid, unsigned stream) {
    return valueNoise(at * glm::vec2(grid), grid, stream);
}

/// Random displacement, each component in [-0.5, 0.5].
glm::vec2 shift(const glm::vec2& at, const glm::ivec2& grid, unsigned across, unsigned along) {
    return {noise(at, grid, across) - 0.5f, noise(at, grid, along) - 0.5f};
}

/// The nearest of random points, one in each cell of a grid (Worley 1996).
struct Plate {
    float edge; ///< Distance from the edge to the next plate, in cells.
    float own;  ///< Random number of the plate, [0, 1).
};
Plate plateAt(const glm::vec2& at, const glm::ivec2& grid, unsigned stream) {
    const glm::vec2 place = at * glm::vec2(grid);
    const glm::ivec2 cell(wholeBelow(place.x), wholeBelow(place.y));
    std::uint32_t columns[3], rows[3]; // around the cell
    for (int i = 0; i < 3; ++i) {
        columns[i] = wrapped(cell.x + i - 1, grid.x);
        rows[i] = wrapped(cell.y + i - 1, grid.y);
    }
    float nearest = 9.0f, next = 9.0f, own = 0.0f;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const glm::vec2 point =
                glm::vec2(cell + glm::ivec2(i - 1, j - 1)) +
                glm::vec2(randomAt(columns[i], rows[j], stream), randomAt(columns[i], rows[j], stream + 1));
            const float away = glm::distance(place, point);
            next = glm::min(next, glm::max(away, nearest));
            if (away < nearest) {
                nearest = away;
                own = randomAt(columns[i], rows[j], stream + 2);
            }
        }
    return {next - nearest, own};
}

/// Place moved around the stem at random.
glm::vec2 sidewaysWarped(const glm::vec2& at) {
    return at + glm::vec2(0.06f * (noise(at, {4, 8}, 2) - 0.5f), 0.0f);
}

/// The scar of a shed branch: an eye below a brow that falls to both sides. @param at place from the middle
/// of the scar, over half its width. @return [0, 1].
float scarAt(const glm::vec2& at) {
    const float beside = glm::abs(at.x), above = at.y - 0.55f + 0.55f * beside * beside;
    const float brow =
        (1.0f - glm::smoothstep(0.0f, 0.22f, glm::abs(above))) * (1.0f - glm::smoothstep(0.3f, 1.5f, beside));
    const float eye =
        1.0f - glm::smoothstep(0.1f, 0.3f, glm::abs(glm::length(at * glm::vec2(0.8f, 1.5f)) - 0.3f));
    return glm::max(brow, 0.6f * eye);
}

/// Two scars on the texture.
float scars(const glm::vec2& at, float size) {
    const auto from = [&](const glm::vec2& middle) {
        const glm::vec2 away = at - middle;
        return glm::vec2(1.0f, 2.0f) * (away - glm::floor(away + 0.5f));
    };
    const glm::vec2 rough = 0.12f * shift(at, {40, 60}, 31, 32);
    return glm::max(scarAt(from({0.24f, 0.31f}) / size + rough),
                    0.8f * scarAt(from({0.71f, 0.87f}) / (0.7f * size) + rough));
}

/// Thin fissures along the stem, open in places. @param count around the texture.
float fissures(const glm::vec2& at, float count) {
    const float place = count * at.x + 1.2f * noise(at, {5, 6}, 33) + 0.3f * noise(at, {24, 30}, 34);
    return 1.0f -
           glm::smoothstep(0.0f, 0.12f,
                           glm::abs(math::sin(glm::pi<float>() * place)) + 0.4f * noise(at, {5, 9}, 35));
}

/// Small dots, of cork pores. @param grid number of cells, of which a third has a dot.
float lenticels(const glm::vec2& at, const glm::ivec2& grid, unsigned stream) {
    const Plate cell = plateAt(at, grid, stream);
    return cell.own < 0.35f ? glm::smoothstep(0.25f, 0.6f, cell.edge) : 0.0f;
}

// Each bark returns brightness, height and hue of old bark, and brightness of young bark. Brightness is
// relative.
// @param grain the finest noise, [-0.5, 0.5].

/// Ridges along the stem that meet and part, with furrows of V shape between them.
glm::vec4 furrowedBark(const glm::vec2& at, float grain) {
    const float wander =
        1.7f * noise(at, {4, 4}, 3) + 0.9f * noise(at, {11, 9}, 4) + 0.3f * noise(at, {30, 40}, 7);
    const float ridge = glm::abs(math::sin(glm::pi<float>() * (11.0f * at.x + wander)));
    const float joint = 5.0f * glm::abs(noise(sidewaysWarped(at), {12, 7}, 5) - 0.5f);
    const float crack = glm::smoothstep(0.0f, 0.12f, glm::abs(noise(sidewaysWarped(at), {16, 34}, 9) - 0.5f));
    const float fibre = noise(at, {90, 40}, 8) - 0.5f;
    const float rise = glm::smoothstep(0.0f, 0.9f, glm::min(ridge, 0.25f + joint)) * (0.8f + 0.2f * crack);
    return {0.66f + 0.22f * rise + 0.16f * grain + 0.14f * fibre,
            0.85f * rise + 0.08f * grain + 0.09f * fibre,
            0.45f + 0.15f * rise + 0.25f * (noise(at, {4, 7}, 6) - 0.5f),
            0.76f + 0.12f * (noise(at, {5, 9}, 12) - 0.5f) - 0.2f * fissures(at, 11.0f) +
                0.1f * lenticels(at, {30, 44}, 13) - 0.15f * scars(at, 0.08f) + 0.08f * grain + 0.1f * fibre};
}

/// Long plates between fissures, each of thin layers that flake off. Young bark is of papery flakes.
glm::vec4 platedBark(const glm::vec2& at, float grain) {
    const glm::vec2 rough = 0.05f * shift(at, {14, 20}, 3, 7) + 0.02f * shift(at, {40, 60}, 8, 9);
    const Plate plate = plateAt(sidewaysWarped(at) + rough, {6, 4}, 4),
                flake = plateAt(at + 2.0f * rough, {16, 20}, 10),
                thin = plateAt(at + 2.5f * rough, {9, 13}, 14);
    const float rise = glm::smoothstep(0.0f, 0.28f, plate.edge),
                layer = std::floor(3.0f * flake.own + 1.2f * plate.edge) / 4.0f;
    const float lip = glm::smoothstep(0.0f, 0.06f, flake.edge),
                paper = glm::smoothstep(0.0f, 0.1f, thin.edge);
    return {0.56f + rise * (0.14f + 0.2f * layer + 0.06f * lip) + 0.14f * grain,
            0.7f * rise + 0.22f * layer + 0.08f * grain, 0.38f + rise * (0.1f + 0.3f * flake.own),
            0.66f + 0.2f * thin.own + 0.06f * paper - 0.25f * scars(at, 0.06f) + 0.08f * grain};
}

/// Thin scales of a few centimetres, loose at their lower edges.
glm::vec4 scalyBark(const glm::vec2& at, float grain) {
    const glm::vec2 rough = 0.05f * shift(at, {20, 30}, 3, 7) + 0.02f * shift(at, {60, 90}, 8, 9);
    const Plate scale = plateAt(at + rough, {15, 22}, 4), older = plateAt(at - rough, {8, 11}, 10);
    const float edge = glm::smoothstep(0.0f, 0.3f, scale.edge);
    const float curl = plateAt(at + rough + glm::vec2(0.0f, 0.006f), {15, 22}, 4).own - scale.own;
    return {0.60f + 0.06f * edge + 0.14f * scale.own + 0.10f * older.own + 0.14f * grain,
            0.35f + 0.18f * edge + 0.22f * scale.own + 0.15f * older.own + 0.08f * grain + 0.1f * curl,
            0.40f + 0.25f * scale.own + 0.15f * older.own,
            0.74f + 0.1f * (noise(at, {6, 9}, 12) - 0.5f) + 0.08f * lenticels(at, {26, 40}, 13) +
                0.12f * grain};
}

glm::vec4 smoothBark(const glm::vec2& at, float grain) {
    const float cloud = noise(at, {4, 5}, 3), wrinkle = noise(at, {5, 40}, 4);
    const float fold = glm::smoothstep(0.72f, 0.95f, wrinkle), scar = scars(at, 0.13f);
    const float lichen =
        glm::smoothstep(0.55f, 0.7f, noise(at, {9, 14}, 15) + 0.2f * (noise(at, {30, 50}, 16) - 0.5f));
    const float young = 0.72f + 0.14f * cloud - 0.1f * fold - 0.22f * scar + 0.05f * lichen + 0.06f * grain;
    const float crease = glm::smoothstep(0.6f, 0.95f, noise(at, {11, 70}, 17)) + fissures(at, 13.0f);
    return {young - 0.05f * crease + 0.06f * grain,
            0.6f - 0.1f * fold + 0.05f * cloud - 0.12f * scar - 0.15f * crease,
            0.4f + 0.25f * noise(at, {3, 4}, 5), young};
}

/// Old bark is cracked into rough ridges; young bark has lenticels in lines across.
glm::vec4 bandedBark(const glm::vec2& at, float grain) {
    const float line = noise(at, {5, 130}, 3) * glm::smoothstep(0.3f, 0.7f, noise(at, {3, 14}, 4)),
                stripe = noise(at, {4, 44}, 13) * glm::smoothstep(0.5f, 0.8f, noise(at, {2, 9}, 14));
    const float band =
        glm::max(0.6f * glm::smoothstep(0.45f, 0.6f, line), glm::smoothstep(0.5f, 0.6f, stripe));
    const glm::vec2 rough = 0.05f * shift(at, {14, 20}, 8, 7);
    const Plate ridge = plateAt(sidewaysWarped(at) + rough, {7, 8}, 10);
    const float rise = glm::smoothstep(0.0f, 0.45f, ridge.edge) * (0.7f + 0.3f * noise(at, {20, 16}, 11));
    const float dark = glm::max(0.7f * band, 0.9f * scars(at, 0.15f));
    return {0.6f + 0.25f * rise + 0.3f * grain, 0.25f * noise(at, {3, 3}, 15) + 0.7f * rise + 0.2f * grain,
            0.5f + 0.1f * noise(at, {3, 5}, 6),
            glm::mix(0.9f + 0.06f * noise(at, {5, 9}, 12) + 0.04f * grain, 0.12f + 0.1f * grain, dark)};
}

/// Old bark is of small scales; young bark falls in patches.
glm::vec4 flakingBark(const glm::vec2& at, float grain) {
    const glm::vec2 rough = 0.07f * shift(at, {9, 18}, 3, 4) + 0.03f * shift(at, {25, 50}, 6, 7);
    const Plate old = plateAt(at + rough, {4, 5}, 5), young = plateAt(at - rough, {5, 7}, 8),
                scale = plateAt(at + rough, {14, 14}, 12);
    const float fresh = young.own < 0.35f ? glm::smoothstep(0.0f, 0.04f, young.edge) : 0.0f;
    const float shade = old.own < 0.3f ? 0.55f : old.own < 0.65f ? 0.68f : 0.78f;
    const float edge = glm::smoothstep(0.0f, 0.25f, scale.edge);
    return {0.58f + 0.12f * edge + 0.16f * scale.own + 0.12f * grain, 0.3f + 0.3f * edge + 0.3f * scale.own,
            glm::mix(0.35f + 0.35f * old.own, 0.8f, fresh), glm::mix(shade, 0.96f, fresh) + 0.06f * grain};
}

/// Scars of fallen leaves, each a narrow ridge around the stem; they weather on old bark.
glm::vec4 ringedBark(const glm::vec2& at, float grain) {
    const float along = 12.0f * (at.y + 0.012f * noise(at, {4, 12}, 3) + 0.006f * noise(at, {13, 24}, 9));
    const float part = along - std::floor(along), wear = noise(at, {7, 24}, 10);
    const float scar = glm::smoothstep(0.72f, 0.9f, part) * (1.0f - glm::smoothstep(0.93f, 1.0f, part));
    const float fibre = noise(at, {40, 12}, 4) - 0.5f;
    const float crack = fissures(at, 14.0f);
    return {0.74f + 0.05f * scar * wear - 0.12f * crack + 0.2f * fibre + 0.14f * grain,
            0.5f + 0.12f * scar * wear - 0.2f * crack + 0.1f * fibre, 0.5f + 0.1f * fibre,
            0.70f + 0.18f * scar * (0.5f + 0.5f * wear) + 0.14f * fibre + 0.1f * grain};
}

/// A form of bark.
struct Bark {
    glm::vec4 (*paint)(const glm::vec2&, float);
    glm::vec3 ageing; ///< barkAgeing()
};

constexpr Bark barks[] = {{furrowedBark, {0.03f, 0.12f, 0.004f}}, {platedBark, {0.03f, 0.14f, 0.018f}},
                          {smoothBark, {0.1f, 0.5f, 0.02f}},      {bandedBark, {0.08f, 0.28f, 0.12f}},
                          {flakingBark, {0.15f, 0.5f, 0.1f}},     {ringedBark, {-0.6f, 0.2f, 0.06f}},
                          {scalyBark, {0.03f, 0.12f, 0.008f}}}; // by form

constexpr float meanBrightness = 0.75f;

} // namespace

osg::ref_ptr<osg::Image> paintBark(BarkForm form) {
    std::vector<glm::vec4> texels;
    glm::vec4 sum(0.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / glm::vec2(width, height);
            texels.push_back(barks[static_cast<std::size_t>(form)].paint(at, noise(at, {48, 96}, 1) - 0.5f));
            sum += texels.back();
        }
    const float mean = meanBrightness * static_cast<float>(texels.size());
    const glm::vec4 scale(mean / sum.r, 1.0f, 1.0f, mean / sum.a);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (std::size_t i = 0; i < texels.size(); ++i)
        for (int channel = 0; channel < 4; ++channel)
            image->data()[4 * i + static_cast<std::size_t>(channel)] = byteOf((scale * texels[i])[channel]);
    return image;
}

glm::vec3 barkAgeing(BarkForm form) {
    return barks[static_cast<std::size_t>(form)].ageing;
}

} // namespace osgTreeWind
