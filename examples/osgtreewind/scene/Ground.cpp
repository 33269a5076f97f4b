// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Ground.h>

#include <examples/osgtreewind/scene/Mix.h>
#include <examples/osgtreewind/scene/SceneShaders.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/places/Ground.h>

#include <osg/Texture2D>

#include <algorithm>
#include <cmath>
#include <vector>

namespace math = osgTreeWind::math;

namespace {

using osgTreeWind::Forest;

constexpr int texels = 512; // width and height of the ground texture

float between(osgTreeWind::Random& random, float low, float high) {
    return low + (high - low) * random.uniform();
}

/// Index of the texel at a place on a square that tiles seamlessly.
std::size_t tiledIndex(float x, float y) {
    const int column = static_cast<int>(x) & (texels - 1), row = static_cast<int>(y) & (texels - 1);
    return static_cast<std::size_t>(row * texels + column);
}

/// Paints strokes in all directions on a square that tiles seamlessly; values in [0, 1].
std::vector<float> paintedBlades() {
    osgTreeWind::Random random(11);
    std::vector<float> values(texels * texels, 0.0f);
    for (int blade = 0; blade < texels * texels / 7; ++blade) {
        const float angle = between(random, 0.0f, 6.2832f), shade = between(random, 0.0f, 1.0f);
        const float x = between(random, 0.0f, texels), y = between(random, 0.0f, texels);
        const float length = between(random, 6.0f, 20.0f), cosine = math::cos(angle), sine = math::sin(angle);
        for (float along = 0.0f; along < length; along += 0.7f)
            values[tiledIndex(x + along * cosine, y + along * sine)] = shade * (0.6f + 0.4f * along / length);
    }
    return values;
}

/// Paints fallen leaves on a square that tiles seamlessly. Values are random numbers of the leaves, [0, 0.9);
/// 1 between them.
std::vector<float> paintedLeaves() {
    osgTreeWind::Random random(12);
    std::vector<float> values(texels * texels, 1.0f);
    for (int leaf = 0; leaf < texels * texels / 50; ++leaf) {
        const float angle = between(random, 0.0f, 6.2832f), own = between(random, 0.0f, 0.9f);
        const float x = between(random, 0.0f, texels), y = between(random, 0.0f, texels);
        const float length = between(random, 5.0f, 9.0f), width = between(random, 0.4f, 0.7f);
        const float cosine = math::cos(angle), sine = math::sin(angle);
        for (int i = static_cast<int>(-length); i <= static_cast<int>(length); ++i)
            for (int j = static_cast<int>(-length); j <= static_cast<int>(length); ++j) {
                const auto across = static_cast<float>(i), up = static_cast<float>(j);
                const float along = (cosine * across + sine * up) / length,
                            beside = (cosine * up - sine * across) / (width * length);
                if (std::abs(beside) < 1.0f - along * along)
                    values[tiledIndex(x + across, y + up)] = own;
            }
    }
    return values;
}

osg::ref_ptr<osg::Image> paintedGround() {
    const std::vector<float> blades = paintedBlades(), leaves = paintedLeaves();
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texels, texels, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const auto patch = [](int x, int y, std::uint32_t seed) {
        constexpr int period = 5;
        const glm::vec2 place = glm::vec2(x, y) * (static_cast<float>(period) / texels);
        const float noise = osgTreeWind::fractalNoise(place, 5, glm::ivec2(period), seed);
        return std::clamp(0.5f + 1.6f * (noise - 0.5f), 0.0f, 1.0f);
    };
    unsigned char* texel = image->data();
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x) {
            const auto at = static_cast<std::size_t>(y * texels + x);
            const float values[] = {patch(x, y, 1), patch(x, y, 21), blades[at], leaves[at]};
            for (const float value : values)
                *texel++ = static_cast<unsigned char>(255.0f * value);
        }
    return image;
}

osg::ref_ptr<osg::Texture2D> groundTexture() {
    static const osg::ref_ptr<osg::Image> image = paintedGround();
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setUnRefImageDataAfterApply(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    return texture;
}

/// Middle and half widths of the ground, and where haze begins to hide its edge.
struct Rim {
    osg::Vec2 middle, half;
    float start;
};

/// @param define preprocessor lines for both shaders.
osg::ref_ptr<osg::StateSet> grass(const std::string& define, const Rim& rim) {
    using osgTreeWind::sceneShader, osgTreeWind::shaderText;
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(
        osgTreeWind::makeProgram("ground",
                                 define + shaderText("shadowed.glsl") + shaderText("fog.glsl") +
                                     sceneShader("glow.glsl") + sceneShader("ground.vert"),
                                 define + shaderText("scene.glsl") + sceneShader("ground.frag")));
    state->setTextureAttribute(0, groundTexture());
    state->addUniform(new osg::Uniform("groundTexture", 0));
    state->addUniform(
        new osg::Uniform("rim", osg::Vec4(rim.middle.x(), rim.middle.y(), rim.half.x(), rim.half.y())));
    state->addUniform(new osg::Uniform("rimStart", rim.start));
    return state;
}

/// Edge of the forest's ground; haze begins beyond the trees.
Rim reliefRim(const Forest& forest) {
    const osgTreeWind::GroundArea area = forest.getDescription().ground->area();
    const osg::Vec3d origin = forest.getOrigin();
    const osg::BoundingSphere& drawn = forest.getGround()->getBound();
    const osg::BoundingSphere& trees = forest.getBound();
    Rim rim;
    float trunks = 0.0f;
    for (int i = 0; i < 2; ++i) {
        const double low = std::max(area.low[i] - origin[i], double(drawn.center()[i] - drawn.radius())),
                     high = std::min(area.high[i] - origin[i], double(drawn.center()[i] + drawn.radius()));
        rim.middle[i] = static_cast<float>(0.5 * (low + high));
        rim.half[i] = static_cast<float>(0.5 * (high - low));
        trunks =
            std::max(trunks, (std::abs(trees.center()[i] - rim.middle[i]) + trees.radius()) / rim.half[i]);
    }
    rim.start = std::clamp(1.2f * trunks, 0.5f, 0.95f);
    return rim;
}

Rim levelRim(const Forest& forest) {
    const osg::BoundingSphere& bound = forest.getBound();
    const float radius = groundRadius(bound);
    return {{bound.center().x(), bound.center().y()}, {radius, radius}, 0.7f};
}

/// Disc around the eye, in rings that widen with the distance.
osg::ref_ptr<osg::Geometry> createLevel(const Rim& rim) {
    constexpr int spokes = 48, rings = 24;
    const float radius = rim.half.x();
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (int ring = 0; ring <= rings; ++ring) {
        const float away =
            ring == 0 ? 0.0f : radius * math::pow(0.5f, 0.5f * static_cast<float>(rings - ring));
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double angle = 2.0 * osg::PI * spoke / spokes;
            corners->push_back({away * static_cast<float>(math::cos(angle)),
                                away * static_cast<float>(math::sin(angle)), 0.0f});
        }
    }
    osg::ref_ptr<osg::DrawElementsUShort> triangles = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int ring = 0; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const int first = ring * spokes + spoke, beside = ring * spokes + (spoke + 1) % spokes;
            for (const int corner : {first, first + spokes, beside + spokes, first, beside + spokes, beside})
                triangles->push_back(static_cast<GLushort>(corner));
        }
    osg::ref_ptr<osg::Geometry> ground = new osgTreeWind::SceneGeometry;
    ground->setVertexArray(corners);
    ground->addPrimitiveSet(triangles);
    const osg::Vec3 middle(rim.middle, 0.0f), reach(radius, radius, 0.0f);
    ground->setInitialBound(osg::BoundingBox(middle - reach, middle + reach));
    ground->setCullingActive(false); // it follows the eye
    return ground;
}

/// Sets the colours of grass and litter for a season.
void setSeasonColors(osg::StateSet& state, float season) {
    using osg::Vec3;
    struct Colors {
        Vec3 grass, litter;
    };
    static const Colors colors[] = {{{1.15f, 0.88f, 0.95f}, {0.115f, 0.080f, 0.045f}},  // winter
                                    {{0.95f, 1.10f, 0.80f}, {0.100f, 0.075f, 0.042f}},  // spring
                                    {{1.00f, 1.00f, 1.00f}, {0.075f, 0.062f, 0.034f}},  // summer
                                    {{1.15f, 0.95f, 0.90f}, {0.220f, 0.110f, 0.034f}}}; // autumn
    // Colours change in the middle half of the interval between two seasons.
    const float from = std::floor(season), part = std::clamp(2.0f * (season - from) - 0.5f, 0.0f, 1.0f);
    const Colors &now = colors[static_cast<int>(from) & 3], &next = colors[(static_cast<int>(from) + 1) & 3];
    state.addUniform(new osg::Uniform("season", mix(now.grass, next.grass, part)));
    state.addUniform(new osg::Uniform("litter", mix(now.litter, next.litter, part)));
}

} // namespace

void setGroundLight(osg::StateSet& state, const Daylight& day) {
    state.addUniform(new osg::Uniform("skyLight", day.sky));
}

float groundRadius(const osg::BoundingSphere& bound) {
    return std::max(6000.0f, 8.0f * bound.radius());
}

osg::ref_ptr<osg::StateSet> createGrassState(const Forest& forest, const GroundCover& cover,
                                             const std::string& define) {
    const bool isRelief = forest.getGround() != nullptr;
    std::string defines = define + (isRelief ? "#define RELIEF\n" : "");
    if (!cover.isEmpty())
        defines += "#define COVERED\n";
    const osg::ref_ptr<osg::StateSet> state = grass(defines, isRelief ? reliefRim(forest) : levelRim(forest));
    cover.setUniforms(*state, 7); // lower units belong to the forest and its shadows
    setSeasonColors(*state, forest.getSeason());
    return state;
}

osg::ref_ptr<osg::Node> createGround(const Forest& forest, const GroundCover& cover) {
    osg::ref_ptr<osg::Group> ground = new osg::Group;
    ground->addChild(forest.getGround() ? forest.getGround() : createLevel(levelRim(forest)).get());
    ground->setStateSet(createGrassState(forest, cover, forest.getGround() ? "" : "#define LEVEL\n"));
    return ground;
}
