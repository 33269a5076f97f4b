// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/portraits/TreeLooks.h>

#include <examples/osgtreewind/portraits/CrownDrawing.h>
#include <examples/osgtreewind/portraits/LeafMasks.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Srgb.h>
#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>
#include <osgTreeWind/drawing/impostors/LightLobe.h>
#include <osgTreeWind/drawing/impostors/TreeView.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <iterator>

namespace osgTreeWind {
namespace {

constexpr int shapes = 3, azimuths = 3, viewPixels = 600, viewSamples = 4;
/// The outline is closed by squares as large as discs with these radii, over the height of the crown.
constexpr float closingRadii[] = {0.04f, 0.08f};
/// Covered share of a pixel from which on it is dark in a picture: the tree itself is lit.
constexpr float darkShare = 0.6f;
constexpr float squareSide = 1.77f; ///< Over the radius of a disc of the same area.

/// A tree seen from one side, at the height of its crown.
class CrownView {
public:
    CrownView(const TreeModel& model, float azimuth) : _model(model), _view(azimuth, 0.0f) {
        glm::vec2 low(1e9f), high(-1e9f);
        forEachLeafQuad(model, [&](std::size_t, std::size_t, const glm::vec3& corner, const glm::vec3& across,
                                   const glm::vec3& along) {
            for (const glm::vec3& p : {corner, corner + across, corner + along, corner + across + along}) {
                low = glm::min(low, glm::vec2(_view(p)));
                high = glm::max(high, glm::vec2(_view(p)));
            }
        });
        const glm::vec2 size = high - low;
        const float margin = 0.1f * glm::max(size.x, size.y); // room for closing
        _low = low - margin;
        _scale = viewSamples * viewPixels / (glm::max(size.x, size.y) + 2.0f * margin);
    }

    glm::vec2 operator()(const glm::vec3& p) const { return _scale * (glm::vec2(_view(p)) - _low); }

    /// Share of sky within the outline of the crown. @param leaves masks of the cards.
    float sky(const LeafMasks& masks, const Silhouette::Mask& (LeafMasks::*leaves)(int) const) const {
        Silhouette samples(viewSamples * viewPixels);
        forEachLeafQuad(_model, [&](std::size_t cluster, std::size_t quad, const glm::vec3& corner,
                                    const glm::vec3& across, const glm::vec3& along) {
            const LeafAtlas::Choice choice = LeafAtlas::choose(cluster, quad);
            drawPiece(*this, corner, across, along, (masks.*leaves)(choice.variant), samples,
                      choice.mirrored);
        });
        drawWood(
            _model.skeleton, *this, [&](const glm::vec3&) { return _scale; }, samples);
        Silhouette tree = samples.shrunk(viewSamples, darkShare);
        const int height = tree.cutStem();
        float sum = 0.0f;
        for (const float radius : closingRadii) {
            const Silhouette outline =
                tree.outline(static_cast<int>(squareSide * radius * static_cast<float>(height)));
            sum += 1.0f - static_cast<float>(outline.common(tree)) / static_cast<float>(outline.count());
        }
        return sum / static_cast<float>(std::size(closingRadii));
    }

private:
    const TreeModel& _model;
    TreeView _view;
    glm::vec2 _low;
    float _scale;
};

/// Shares of sky in summer and winter, mean over all sides of a model.
glm::vec2 skyThrough(const TreeModel& model, const LeafMasks& masks) {
    glm::vec2 sum(0.0f);
    for (int i = 0; i < azimuths; ++i) {
        const CrownView view(model, glm::two_pi<float>() * (static_cast<float>(i) + 0.25f) / azimuths);
        sum += glm::vec2(view.sky(masks, &LeafMasks::leaves), view.sky(masks, &LeafMasks::twigs));
    }
    return sum / static_cast<float>(azimuths);
}

/// Mean angle from the horizontal of the leaves on cards with an inclination, radians.
float inclinationOf(float card, const LeafSpray& spray) {
    constexpr int ways = 8;
    double sum = 0.0, area = 0.0;
    for (const LeafBlade& blade : spray.blades) {
        const double own = static_cast<double>(blade.length * blade.length);
        for (int i = 0; i < ways; ++i) {
            const float way = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / ways;
            const float up = math::cos(card) * math::cos(blade.tilt) +
                             math::sin(card) * math::sin(blade.tilt) * math::cos(way);
            sum += own * static_cast<double>(math::acos(glm::clamp(glm::abs(up), 0.0f, 1.0f))) / ways;
        }
        area += own;
    }
    return area > 0.0 ? static_cast<float>(sum / area) : card;
}

/// Area of all quads, and that area times the mean inclination of their leaves in degrees. The quads of a
/// flat spray are halves of leaves; its face is that of whole leaves.
glm::vec2 quadsOf(const TreeModel& model, const LeafParameters& leaves, const LeafSpray& spray) {
    constexpr int steps = 18;
    float areas[steps + 1] = {};
    const bool isFlat = leaves.inclination > 0.0f && !leaves.hanging && !leaves.frond;
    forEachLeafQuad(model, [&](std::size_t cluster, std::size_t, const glm::vec3&, const glm::vec3& across,
                               const glm::vec3& along) {
        glm::vec3 normal = glm::cross(across, along);
        const float area = glm::length(normal);
        if (isFlat)
            normal = area * (model.leaves[cluster].orientation * glm::vec3(0, 1, 0));
        if (area > 0.0f)
            areas[static_cast<std::size_t>(glm::round(
                steps * math::acos(glm::min(glm::abs(normal.z) / area, 1.0f)) / glm::half_pi<float>()))] +=
                area;
    });
    glm::vec2 sum(0.0f);
    for (std::size_t i = 0; i <= steps; ++i)
        sum += areas[i] * glm::vec2(1.0f, glm::degrees(inclinationOf(
                                              glm::half_pi<float>() * static_cast<float>(i) / steps, spray)));
    return sum;
}

glm::vec3 srgbOf(const glm::vec3& light) {
    const glm::vec3 shown = glm::min(light, 1.0f);
    return {srgbOfLinear(shown.r), srgbOfLinear(shown.g), srgbOfLinear(shown.b)};
}

/// Hue in degrees of a colour that is not grey.
float hueOf(const glm::vec3& c) {
    const float most = std::max({c.r, c.g, c.b}), chroma = most - std::min({c.r, c.g, c.b});
    const float sixth = most == c.r   ? (c.g - c.b) / chroma
                        : most == c.g ? 2.0f + (c.b - c.r) / chroma
                                      : 4.0f + (c.r - c.g) / chroma;
    return 60.0f * glm::mod(sixth, 6.0f);
}

/// Hues and green shares of lit leaves as they appear on the screen.
struct LeafColors {
    std::vector<float> hues;
    double green = 0.0;

    void add(const TreeModel& model, const Appearance& appearance) {
        // The same light as in `osgtreewind render` and shaders/light.glsl.
        const glm::vec3 toSun = glm::normalize(glm::vec3(0.45f, -0.5f, 0.74f)), sun{1.5f, 1.4f, 1.18f},
                        ambient{0.34f, 0.39f, 0.47f};
        const glm::vec3 fromBelow = ambient * glm::vec3(0.75f, 0.72f, 0.62f),
                        fromAbove = ambient * glm::vec3(1.1f, 1.2f, 1.35f);
        const float brighter =
            0.6f / std::max(std::max({appearance.leaves.r, appearance.leaves.g, appearance.leaves.b}),
                            0.01f); // 8 bits are coarse
        Appearance painted = appearance;
        painted.leaves *= brighter;
        const ImpostorPictures pictures = paintImpostor(model, painted, {4, 2, 256, 1, 1.0f});
        const auto texel = [](const osg::Image& image, int x, int y) {
            const unsigned char* t = image.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            return glm::vec4(t[0], t[1], t[2], t[3]) / 255.0f;
        };
        for (int y = 0; y < pictures.pixels; ++y) // the lower row is that of the horizon
            for (int x = 0; x < pictures.azimuths * pictures.pixels; ++x) {
                const glm::vec4 color = texel(*pictures.colors, x, y), light = texel(*pictures.normals, x, y);
                if (color.a < 1.0f || light.a < 1.0f)
                    continue;
                const glm::vec3 way = LightLobe::maxGradient * (2.0f * glm::vec3(light) - 1.0f);
                const glm::vec3 sky = glm::mix(fromBelow, fromAbove, 0.5f + 0.5f * way.z);
                const float sunny = 0.5f + 0.5f * glm::dot(way, toSun);
                const glm::vec3 seen =
                    srgbOf(glm::vec3(color) / brighter * glm::max(sky + sunny * sun, 0.0f));
                const float sum = seen.r + seen.g + seen.b;
                if (seen.r == seen.g && seen.g == seen.b)
                    continue;
                hues.push_back(hueOf(seen));
                green += static_cast<double>(seen.g / sum);
            }
    }

    float spread() {
        if (hues.empty())
            return 0.0f;
        std::sort(hues.begin(), hues.end());
        return hues[hues.size() * 9 / 10] - hues[hues.size() / 10];
    }
    float greenShare() const {
        return hues.empty() ? 0.0f : static_cast<float>(green / static_cast<double>(hues.size()));
    }
};

} // namespace

TreeLooks measureLooks(const Species& species) {
    const LeafMasks masks(*leafImage(species.appearance));
    const LeafSpray spray = growSpray(species.appearance.leafForm);
    TreeLooks looks;
    LeafColors colors;
    glm::vec2 sky(0.0f), quads(0.0f);
    for (std::uint32_t shape = 0; shape < shapes; ++shape) {
        const TreeModel model = makeTreeModel(species.tree, shape);
        const TreeSize size = measureTree(model);
        looks.crownOverStem += size.crownWidth / size.trunkDiameter / shapes;
        looks.leafAreaMechanics += leafArea(model, {}, species) / shapes;
        if (model.leaves.empty())
            continue;
        quads += quadsOf(model, species.tree.leaves, spray);
        sky += skyThrough(model, masks) / static_cast<float>(shapes);
        colors.add(model, species.appearance);
    }
    looks.skyThroughCrownSummer = sky.x;
    looks.skyThroughCrownWinter = species.appearance.isEvergreen() ? sky.x : sky.y;
    looks.leafInclination = quads.x > 0.0f ? quads.y / quads.x : 0.0f;
    looks.leafAreaDrawn = masks.leafCoverage() * quads.x / flatLeafArea(species.appearance.leafForm) / shapes;
    looks.hueSpread = colors.spread();
    looks.greenShare = colors.greenShare();
    return looks;
}

} // namespace osgTreeWind
