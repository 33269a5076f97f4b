// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Sky.h>

#include <examples/osgtreewind/scene/Mix.h>
#include <examples/osgtreewind/scene/SceneShaders.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/Depth>
#include <osg/Texture2D>

#include <algorithm>
#include <tuple>
#include <vector>

namespace math = osgTreeWind::math;

namespace {

using osgTreeWind::fractalNoise, osgTreeWind::sceneShader, osgTreeWind::valueNoise;

const glm::ivec2 everywhere(1 << 20); // noise that does not repeat
constexpr int texelsAround = 2048, texelsUp = 512;
constexpr float lowest = -1.5f; // elevation at the bottom of the texture, degrees; below it is haze

/// Elevation in degrees. @param part position in the texture from its bottom; low elevations get more texels.
float elevationAt(float part) {
    return lowest + (90.0f - lowest) * part * part;
}

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

osg::Vec3 directionAt(float azimuth, float elevation) {
    return {math::cos(azimuth) * math::cos(elevation), math::sin(azimuth) * math::cos(elevation),
            math::sin(elevation)};
}

/// Cumulus clouds at one height, lit from the side of the sun.
class Clouds {
public:
    explicit Clouds(const Daylight& day) : _cover(day.clouds), _toSun(day.toSun) {}

    /// Cover and brightness of the clouds in a direction, both 0 to 1.
    std::pair<float, float> toward(const osg::Vec3& direction) const {
        const osg::Vec2 place = osg::Vec2(direction.x(), direction.y()) * (1.9f / (direction.z() + 0.10f));
        const float here = thickness(place, 6);
        if (!(here > 0.0f))
            return {0.0f, 1.0f};
        osg::Vec2 sunward(_toSun.x(), _toSun.y());
        sunward.normalize();
        const float toSun = thickness(place + sunward * 0.16f, 4);
        const float lit = std::clamp(0.72f + 0.9f * (here - toSun) - 0.42f * here, 0.0f, 1.0f);
        return {smoothstep(0.0f, 0.13f, here), lit};
    }

private:
    float thickness(const osg::Vec2& at, int octaves) const {
        const glm::vec2 place(at.x(), at.y());
        const float where = fractalNoise(0.33f * place, 2, everywhere, 5);
        const float warp = 0.35f * valueNoise(1.7f * place, 16 * everywhere, 9);
        const float heap = fractalNoise(1.15f * place + glm::vec2(warp, -warp), octaves, everywhere, 17);
        return 0.45f * where + 0.55f * heap - (0.66f - 0.32f * _cover);
    }

    float _cover;
    osg::Vec3 _toSun;
};

/// Elevation of a skyline of wooded hills, degrees; seamless around the horizon.
float skylineAt(float azimuth, int seed) {
    constexpr int waves = 7, trees = 512; // around
    const float turn = azimuth / static_cast<float>(2.0 * osg::PI);
    const float hills =
        fractalNoise({waves * turn, 0.5f}, 3, glm::ivec2(waves), static_cast<std::uint32_t>(seed));
    const float crowns =
        valueNoise({trees * turn, 0.5f}, glm::ivec2(trees), static_cast<std::uint32_t>(seed));
    return 3.4f * std::max(hills - 0.3f, 0.0f) + 0.12f * crowns;
}

/// Adds two skylines of hills; the farther one is higher and hazier.
osg::Vec3 withHills(const osg::Vec3& sky, const Daylight& day, float azimuth, float elevation) {
    constexpr float highest = 3.0f; // above any value of skylineAt()
    if (elevation > highest)
        return sky;
    const osg::Vec3 woods(0.16f, 0.22f, 0.15f);
    osg::Vec3 color = sky;
    for (const auto& [seed, height, hazy] : {std::tuple(41, 1.0f, 0.85f), std::tuple(43, 0.55f, 0.66f)}) {
        const float above = elevation - height * skylineAt(azimuth, seed);
        color = mix(color, mix(woods, day.haze, hazy), 1.0f - smoothstep(-0.06f, 0.06f, above));
    }
    return color;
}

/// What all texels of a row have in common.
struct SkyRow {
    float elevation;     ///< Degrees.
    float level, height; ///< Cosine and sine of the elevation.
    osg::Vec3 clear;     ///< Display colour away from the sun.
    float hazy, cloudy;  ///< Weights of the haze, and of the clouds.

    SkyRow(const Daylight& day, float part) {
        const auto radians = osg::DegreesToRadians(elevationAt(part));
        elevation = osg::RadiansToDegrees(radians);
        level = math::cos(radians);
        height = math::sin(radians);
        const float up = std::clamp(height, 0.0f, 1.0f);
        clear = mix(day.zenith, day.horizon, math::pow(1.0f - up, 3.0f));
        hazy = math::pow(1.0f - up, 12.0f);
        cloudy = smoothstep(0.015f, 0.14f, height);
    }
};

/// Display colour of the sky in a direction.
osg::Vec3 skyColor(const Daylight& day, const Clouds& clouds, const SkyRow& row, const osg::Vec3& direction) {
    const float toSun = std::max(direction * day.toSun, 0.0f);
    osg::Vec3 color = row.clear, light;
    if (toSun > 0.0f) {
        light = day.glow * (math::pow(toSun, 16.0f) + 1.3f * math::pow(toSun, 220.0f));
        color += light;
    }
    color = mix(color, osg::Vec3(1.0f, 0.99f, 0.95f), smoothstep(0.99993f, 0.99998f, toSun) * day.disc);
    if (direction.z() > 0.0f) {
        const auto [hidden, lit] = clouds.toward(direction);
        const osg::Vec3 cloud = mix(day.cloudShade, day.cloudLight, lit) + light * 0.35f;
        color = mix(color, cloud, hidden * row.cloudy);
    }
    return mix(color, day.haze + light * 0.5f, row.hazy);
}

osg::ref_ptr<osg::Texture2D> paintedSky(const Daylight& day) {
    const Clouds clouds(day);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texelsAround, texelsUp, 1, GL_RGB, GL_UNSIGNED_BYTE);
    std::vector<osg::Vec3> columns; // azimuth, and its cosine and sine
    for (int x = 0; x < texelsAround; ++x) {
        const auto azimuth = static_cast<float>(2.0 * osg::PI * (x + 0.5) / texelsAround);
        columns.emplace_back(azimuth, math::cos(azimuth), math::sin(azimuth));
    }
    osgTreeWind::ThreadPool::executor()(texelsUp, [&](std::size_t row) {
        const SkyRow common(day, (static_cast<float>(row) + 0.5f) / texelsUp);
        unsigned char* texel = image->data(0, static_cast<int>(row)); // osg::Image::data() is slow per texel
        for (int x = 0; x < texelsAround; ++x) {
            const osg::Vec3& column = columns[static_cast<std::size_t>(x)];
            const osg::Vec3 direction(column.y() * common.level, column.z() * common.level, common.height);
            const osg::Vec3 color =
                withHills(skyColor(day, clouds, common, direction), day, column.x(), common.elevation);
            // Noise of one step avoids visible bands.
            const float rough = valueNoise(glm::vec2(x, row), everywhere, 3);
            for (int i = 0; i < 3; ++i)
                *texel++ = static_cast<unsigned char>(std::clamp(255.0f * color[i] + rough, 0.0f, 255.0f));
        }
    });
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

osg::ref_ptr<osg::Geometry> createDome() {
    constexpr int columns = 64, rows = 17;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> spots = new osg::Vec2Array;
    for (int row = -1; row < rows; ++row) { // the first row is the nadir
        const float part = row < 0 ? 0.0f : static_cast<float>(row) / (rows - 1);
        const float degrees = row < 0 ? -90.0f : elevationAt(part);
        for (int column = 0; column <= columns; ++column) {
            const auto azimuth = static_cast<float>(2.0 * osg::PI * column / columns);
            corners->push_back(directionAt(azimuth, static_cast<float>(osg::DegreesToRadians(degrees))));
            spots->push_back({static_cast<float>(column) / columns, part});
        }
    }
    osg::ref_ptr<osg::DrawElementsUShort> triangles = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int first = row * (columns + 1) + column, above = first + columns + 1;
            for (const int corner : {first, first + 1, above, above, first + 1, above + 1})
                triangles->push_back(static_cast<GLushort>(corner));
        }
    osg::ref_ptr<osg::Geometry> dome = new osg::Geometry;
    dome->setUseDisplayList(false);
    dome->setUseVertexBufferObjects(true);
    dome->setVertexArray(corners);
    dome->setTexCoordArray(0, spots);
    dome->addPrimitiveSet(triangles);
    return dome;
}

} // namespace

void setGlow(osg::StateSet& state, const Daylight& day) {
    state.addUniform(new osg::Uniform("sunDirection", day.toSun));
    state.addUniform(new osg::Uniform("sunGlow", day.glow));
}

osg::ref_ptr<osg::Geometry> createSky(const Daylight& day) {
    struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
        osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
    };
    osg::ref_ptr<osg::Geometry> sky = createDome();
    sky->setComputeBoundingBoxCallback(new NoBounds);
    sky->setCullingActive(false);
    osg::StateSet* state = sky->getOrCreateStateSet();
    state->setAttributeAndModes(
        osgTreeWind::makeProgram("sky", sceneShader("sky.vert"), sceneShader("sky.frag")));
    state->setTextureAttribute(0, paintedSky(day));
    state->addUniform(new osg::Uniform("sky", 0));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setRenderBinDetails(10, "RenderBin"); // drawn late, so that only visible sky is shaded
    return sky;
}
