// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Ground.h>

#include <examples/osgtreewind/scene/Sky.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/places/Ground.h>

#include <osg/Texture2D>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using osgTreeWind::Forest;

constexpr int texels = 256; // of the ground's texture, each way

const char* groundVertexText = R"(
out vec2 place;
out vec3 eyePosition;
#ifdef TUFTS
out float rise, shade; // of a blade of grass, from its foot to its tip; own
#endif
out vec3 light;
#ifdef SHADOWED
out
#endif
vec3 sunLight;
uniform vec3 skyLight;
uniform float sunOnGround;
void main() {
    place = gl_Vertex.xy;
#ifdef TUFTS
    rise = gl_MultiTexCoord0.x;
    shade = gl_MultiTexCoord0.y;
#endif
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    eyePosition = eye.xyz;
#ifdef RELIEF
    vec3 up = normalize(gl_NormalMatrix * gl_Normal);
#else
    vec3 up = normalize(gl_NormalMatrix * vec3(0.0, 0.0, 1.0));
#endif
    float facing = max(dot(up, normalize(gl_LightSource[0].position.xyz)), 0.0);
#ifdef TUFTS
    facing = mix(0.35, 1.0, facing); // they stand up
#endif
    sunLight = sunOnGround * facing * gl_LightSource[0].diffuse.rgb;
    light = 1.2 * skyLight + sunLight;
    gl_Position = gl_ProjectionMatrix * eye;
})";

// Each scale is turned and in no simple ratio to the others, so that the texture does not show.
const char* groundFragmentText = R"(
in vec2 place;
in vec3 eyePosition;
#ifdef TUFTS
in float rise, shade;
#define WORN 0.25 // what is left there is green
#else
#define WORN 0.6
#endif
in vec3 light;
uniform vec4 rim;                // middle, half of its width each way
uniform float rimStart;          // part of the way to it from where on haze hides what is left
uniform sampler2D groundTexture; // red: patches, alpha: blades of grass
void main() {
    vec2 p = place;
    vec2 q = vec2(0.80 * p.x - 0.60 * p.y, 0.60 * p.x + 0.80 * p.y);
    vec2 r = vec2(0.28 * p.x + 0.96 * p.y, 0.28 * p.y - 0.96 * p.x);
    float wide = texture(groundTexture, q / 613.0).r;
    float patches = texture(groundTexture, r / 97.0).r;
    float tufts = texture(groundTexture, p / 11.3).r;
#ifdef TUFTS
    float blades = 0.1 + 0.5 * rise + 0.3 * shade;
#else
    float blades = 0.5 * (texture(groundTexture, q / 1.7).a + texture(groundTexture, r / 4.9).a);
#endif
    float tone = smoothstep(0.25, 0.75, 0.35 * wide + 0.35 * patches + 0.3 * tufts);
    vec3 grass = mix(vec3(0.040, 0.082, 0.016), vec3(0.115, 0.160, 0.036), tone);
    float worn = smoothstep(0.50, 0.68, 0.5 * texture(groundTexture, p / 271.0).r + 0.3 * patches + 0.2 * tufts);
    grass = mix(grass, vec3(0.200, 0.165, 0.080), WORN * worn);
    vec3 color = sceneColor((0.35 + 1.3 * blades) * grass * shadowed(light, sunLight, eyePosition), eyePosition);
    vec2 way = abs(place - rim.xy) / rim.zw;
#ifdef RELIEF
    float toRim = max(way.x, way.y);
#else
    float toRim = length(way);
#endif
    float kept = 1.0 - smoothstep(rimStart, 1.0, toRim);
    vec3 look = normalize(mat3(gl_ModelViewMatrixInverse) * eyePosition);
#if !defined(RELIEF) && !defined(TUFTS)
    kept *= smoothstep(0.0, 0.012, -look.z); // mist: from near the ground its rim is a line
#endif
    color = mix(gl_Fog.color.rgb, color, kept);
    gl_FragColor = vec4(color + (1.0 - kept * fogLeft(eyePosition)) * glow(look), 1.0);
})";

float between(osgTreeWind::Random& random, float low, float high) {
    return low + (high - low) * random.uniform();
}

/// Values in [0, 1) on a square that goes on into itself.
class Tile {
public:
    float& at(int x, int y) {
        return _values[static_cast<std::size_t>((y & (texels - 1)) * texels + (x & (texels - 1)))];
    }

    /// Four octaves of hills.
    void makePatches(osgTreeWind::Random& random) {
        float weight = 0.5f;
        for (int step = texels / 4; step >= texels / 64; step /= 2, weight *= 0.6f) {
            Tile coarse;
            for (int i = 0; i < texels * texels; i += step)
                coarse._values[static_cast<std::size_t>(i)] = between(random, -weight, weight);
            for (int y = 0; y < texels; ++y)
                for (int x = 0; x < texels; ++x) {
                    const int x0 = x - x % step, y0 = y - y % step;
                    const auto smooth = [&](int part) {
                        const float t = static_cast<float>(part) / static_cast<float>(step);
                        return t * t * (3.0f - 2.0f * t);
                    };
                    const float u = smooth(x % step), v = smooth(y % step);
                    at(x, y) +=
                        (1.0f - v) * ((1.0f - u) * coarse.at(x0, y0) + u * coarse.at(x0 + step, y0)) +
                        v * ((1.0f - u) * coarse.at(x0, y0 + step) + u * coarse.at(x0 + step, y0 + step));
                }
        }
        for (float& value : _values)
            value += 0.5f;
    }
    /// Strokes every way over each other.
    void makeBlades(osgTreeWind::Random& random) {
        for (int blade = 0; blade < texels * texels / 5; ++blade) {
            const float angle = between(random, 0.0f, 6.2832f), shade = between(random, 0.0f, 1.0f);
            const float x = between(random, 0.0f, texels), y = between(random, 0.0f, texels);
            const float length = between(random, 5.0f, 14.0f);
            for (float along = 0.0f; along < length; along += 0.7f)
                at(static_cast<int>(x + along * std::cos(angle)),
                   static_cast<int>(y + along * std::sin(angle))) = shade * (0.6f + 0.4f * along / length);
        }
    }

private:
    std::vector<float> _values = std::vector<float>(texels * texels, 0.0f);
};

osg::ref_ptr<osg::Texture2D> groundTexture() {
    osgTreeWind::Random random(11);
    Tile patches, blades;
    patches.makePatches(random);
    blades.makeBlades(random);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texels, texels, 1, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE);
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x) {
            image->data(x, y)[0] =
                static_cast<unsigned char>(255.0f * std::clamp(patches.at(x, y), 0.0f, 1.0f));
            image->data(x, y)[1] =
                static_cast<unsigned char>(255.0f * std::clamp(blades.at(x, y), 0.0f, 1.0f));
        }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    return texture;
}

/// Half as wide as the ground each way about its middle, and where haze begins to hide its rim.
struct Rim {
    osg::Vec2 middle, half;
    float start;
};

/// @param define a line of both shaders.
osg::ref_ptr<osg::StateSet> grass(const std::string& define, const Rim& rim) {
    using osgTreeWind::shaderText;
    const std::string version = "#version 330 compatibility\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       version + define + shaderText("shadowed.glsl") + groundVertexText));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, version + define + shaderText("scene.glsl") +
                                                                  glowText + groundFragmentText));
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(program);
    state->setTextureAttribute(0, groundTexture());
    state->addUniform(new osg::Uniform("groundTexture", 0));
    state->addUniform(
        new osg::Uniform("rim", osg::Vec4(rim.middle.x(), rim.middle.y(), rim.half.x(), rim.half.y())));
    state->addUniform(new osg::Uniform("rimStart", rim.start));
    return state;
}

/// The haze begins beyond the trees.
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
    return {{bound.center().x(), bound.center().y()}, {radius, radius}, 0.5f};
}

osg::ref_ptr<osg::Geometry> createLevel(const Rim& rim) {
    const osg::Vec3 centre(rim.middle, 0.0f);
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    corners->push_back(centre);
    for (int i = 0; i <= 64; ++i) {
        const double angle = 2.0 * osg::PI * i / 64;
        corners->push_back(centre + osg::Vec3(static_cast<float>(std::cos(angle)),
                                              static_cast<float>(std::sin(angle)), 0.0f) *
                                        rim.half.x());
    }
    osg::ref_ptr<osg::Geometry> ground = new osg::Geometry;
    ground->setUseDisplayList(false);
    ground->setUseVertexBufferObjects(true);
    ground->setVertexArray(corners);
    ground->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, static_cast<int>(corners->size())));
    return ground;
}

} // namespace

osg::ref_ptr<osg::Uniform> sunOnGround(float share) {
    return new osg::Uniform("sunOnGround", share);
}

void setGroundLight(osg::StateSet& state, const Daylight& day) {
    state.addUniform(new osg::Uniform("skyLight", day.sky));
    state.addUniform(sunOnGround(1.0f));
}

float groundRadius(const osg::BoundingSphere& bound) {
    return std::max(3000.0f, 8.0f * bound.radius());
}

osg::ref_ptr<osg::StateSet> createGrassState(const Forest& forest, const std::string& define) {
    const Rim rim = forest.getGround() ? reliefRim(forest) : levelRim(forest);
    return grass((forest.getGround() ? "#define RELIEF\n" : "") + define, rim);
}

osg::ref_ptr<osg::Node> createGround(const Forest& forest) {
    osg::ref_ptr<osg::Group> ground = new osg::Group;
    ground->addChild(forest.getGround() ? forest.getGround() : createLevel(levelRim(forest)).get());
    ground->setStateSet(createGrassState(forest));
    return ground;
}
