// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeTextures.h>

#include <osgTreeWind/model/Random.h>

#include <osg/Notify>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr int leafPixels = 256;
constexpr float leafAlphaThreshold = 0.5f; // shaders/leaf.frag

struct Level {
    int size;
    std::vector<glm::vec4> texels;

    glm::vec4& texel(int x, int y) { return texels[static_cast<std::size_t>(y * size + x)]; }
    /// Share of texels that the alpha test keeps when alpha is multiplied by `scale`.
    float coverage(float scale) const {
        const auto kept = std::count_if(texels.begin(), texels.end(), [=](const glm::vec4& texel) {
            return texel.a * scale >= leafAlphaThreshold;
        });
        return static_cast<float>(kept) / static_cast<float>(texels.size());
    }
};

/// All levels down to one texel. Alpha is scaled on each so that the alpha test keeps the same share of it:
/// the crown stays as dense far away as close by (Castaño, "Computing alpha mipmaps", 2010).
osg::ref_ptr<osg::Image> mipmapped(Level level) {
    const float coverage = level.coverage(1.0f);
    const int levels = static_cast<int>(std::log2(level.size)) + 1;
    std::vector<unsigned char> bytes;
    osg::Image::MipmapDataType offsets;
    for (int i = 0; i < levels; ++i) {
        float low = 0.0f, high = 8.0f;
        for (int step = 0; step < 12 && i > 0; ++step)
            (level.coverage(0.5f * (low + high)) < coverage ? low : high) = 0.5f * (low + high);
        const float scale = i > 0 ? high : 1.0f;
        for (glm::vec4 texel : level.texels) {
            texel.a *= scale;
            for (int channel = 0; channel < 4; ++channel)
                bytes.push_back(
                    static_cast<unsigned char>(255.0f * glm::clamp(texel[channel], 0.0f, 1.0f) + 0.5f));
        }
        if (i + 1 == levels)
            break;
        offsets.push_back(static_cast<unsigned>(bytes.size()));
        Level half{level.size / 2, std::vector<glm::vec4>(level.texels.size() / 4)};
        for (int y = 0; y < half.size; ++y)
            for (int x = 0; x < half.size; ++x)
                half.texel(x, y) =
                    0.25f * (level.texel(2 * x, 2 * y) + level.texel(2 * x + 1, 2 * y) +
                             level.texel(2 * x, 2 * y + 1) + level.texel(2 * x + 1, 2 * y + 1));
        level = std::move(half);
    }
    auto* data = new unsigned char[bytes.size()];
    std::copy(bytes.begin(), bytes.end(), data);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(leafPixels, leafPixels, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, data,
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

/// Draws shapes over each other, `samples`² to a pixel.
class Canvas {
public:
    static constexpr int samples = 3, size = leafPixels * samples;

    Canvas() : _colors(size * size, glm::vec3(0.0f)), _filled(size * size, false) {}

    /// Fills where `color(point)` gives a positive brightness. Points run over [0, 1]².
    template <typename Color>
    void draw(const glm::vec2& low, const glm::vec2& high, Color color) {
        const auto pixel = [](float x) { return glm::clamp(static_cast<int>(x * size), 0, size - 1); };
        for (int y = pixel(low.y); y <= pixel(high.y); ++y) {
            for (int x = pixel(low.x); x <= pixel(high.x); ++x) {
                const glm::vec3 c = color(glm::vec2(x, y) / static_cast<float>(size));
                if (c.x > 0.0f) {
                    _colors[index(x, y)] = c;
                    _filled[index(x, y)] = true;
                }
            }
        }
    }

    osg::ref_ptr<osg::Image> image() const {
        Level level{leafPixels, std::vector<glm::vec4>(leafPixels * leafPixels)};
        for (int y = 0; y < leafPixels; ++y) {
            for (int x = 0; x < leafPixels; ++x) {
                glm::vec3 sum(0.0f);
                int count = 0;
                for (int i = 0; i < samples * samples; ++i) {
                    const std::size_t at = index(x * samples + i % samples, y * samples + i / samples);
                    sum += _colors[at];
                    count += _filled[at];
                }
                // Outside the shape the colour stays leaf-like, so that mipmaps get no dark rim.
                const glm::vec3 color = count ? sum / static_cast<float>(count) : glm::vec3(0.75f);
                level.texel(x, y) = {color, static_cast<float>(count) / (samples * samples)};
            }
        }
        return mipmapped(std::move(level));
    }

private:
    static std::size_t index(int x, int y) {
        return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
    }

    std::vector<glm::vec3> _colors;
    std::vector<bool> _filled;
};

const glm::vec3 twigColor{0.55f, 0.45f, 0.35f};

void drawTwig(Canvas& canvas, float halfWidth, float end) {
    canvas.draw({0.4f, 0.0f}, {0.6f, end}, [=](const glm::vec2& p) {
        const float width = halfWidth * (1.0f - 0.6f * p.y);
        const float middle = 0.5f + 0.015f * glm::sin(9.0f * p.y);
        return std::abs(p.x - middle) < width && p.y < end ? twigColor : glm::vec3(-1.0f);
    });
}

void drawBlade(Canvas& canvas, const glm::vec2& foot, float angle, float length, float width, float shade) {
    const glm::vec2 along{glm::sin(angle), glm::cos(angle)}, side{along.y, -along.x};
    canvas.draw(foot - length, foot + length, [=](const glm::vec2& p) {
        const float u = glm::dot(p - foot, along) / length, v = glm::dot(p - foot, side) / length;
        if (u <= 0.0f || u >= 1.0f)
            return glm::vec3(-1.0f);
        const float half = width * glm::sin(glm::pi<float>() * std::pow(u, 0.75f)) * (1.0f - 0.25f * u);
        if (std::abs(v) > half)
            return glm::vec3(-1.0f);
        const float rib = std::abs(v) < 0.012f ? 1.12f : 1.0f;
        const float veins = 1.0f - 0.06f * glm::step(0.75f, glm::fract(9.0f * (u - 0.9f * std::abs(v))));
        const float edge = 1.0f - 0.15f * std::abs(v) / half;
        return shade * rib * veins * edge * glm::vec3(0.92f + 0.08f * u, 1.0f, 0.85f);
    });
}

osg::ref_ptr<osg::Image> drawSpray() {
    Canvas canvas;
    Random random(7);
    drawTwig(canvas, 0.006f, 0.8f);
    constexpr int shoots = 6, blades = 9;
    for (int shoot = 0; shoot < shoots; ++shoot) {
        // Side shoots left and right, the last one straight on; blades along each.
        const bool end = shoot == shoots - 1;
        const float place = 0.05f + 0.62f * static_cast<float>(shoot) / (shoots - 1);
        const float lean = end ? 0.0f : (shoot % 2 ? 0.95f : -0.95f) + 0.2f * random.symmetric();
        const float reach = end ? 0.3f : 0.42f;
        for (int i = 0; i < blades; ++i) {
            const float t = static_cast<float>(i + 1) / blades;
            const glm::vec2 foot =
                glm::vec2(0.5f, place) + reach * 0.75f * t * glm::vec2(glm::sin(lean), glm::cos(lean));
            const float side = i == blades - 1 ? 0.0f : (i % 2 ? 0.9f : -0.9f);
            drawBlade(canvas, foot, lean + side + 0.45f * random.symmetric(),
                      0.15f * (0.75f + 0.4f * random.uniform()), 0.24f, 0.66f + 0.3f * random.uniform());
        }
    }
    return canvas.image();
}

osg::ref_ptr<osg::Image> drawNeedles() {
    Canvas canvas;
    Random random(11);
    drawTwig(canvas, 0.008f, 0.85f);
    constexpr int shoots = 7, needles = 34;
    for (int shoot = 0; shoot < shoots; ++shoot) {
        const bool end = shoot == shoots - 1;
        const float place = 0.04f + 0.5f * static_cast<float>(shoot) / (shoots - 1);
        const float lean = end ? 0.0f : (shoot % 2 ? 0.85f : -0.85f) + 0.15f * random.symmetric();
        const float reach = end ? 0.42f : 0.45f - 0.25f * place;
        for (int i = 0; i < needles; ++i) {
            const float t = static_cast<float>(i + 1) / needles;
            const glm::vec2 foot =
                glm::vec2(0.5f, place) + reach * t * glm::vec2(glm::sin(lean), glm::cos(lean));
            const float side = (i % 2 ? 0.75f : -0.75f) * (1.0f - 0.6f * t * t);
            drawBlade(canvas, foot, lean + side + 0.2f * random.symmetric(),
                      0.085f * (0.8f + 0.4f * random.uniform()), 0.055f, 0.6f + 0.35f * random.uniform());
        }
    }
    return canvas.image();
}

osg::ref_ptr<osg::Image> drawBark() {
    constexpr int width = 64, height = 128, furrows = 9;
    Random random(3);
    float phases[furrows];
    for (float& phase : phases)
        phase = glm::two_pi<float>() * random.uniform();

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / width,
                        v = glm::two_pi<float>() * static_cast<float>(y) / height;
            float height01 = 0.0f;
            for (int i = 0; i < furrows; ++i) {
                const float wander = 0.9f * glm::sin(v * static_cast<float>(1 + i % 3) + phases[i]);
                height01 += glm::sin(glm::two_pi<float>() * static_cast<float>(i + 2) * u + wander +
                                     phases[furrows - 1 - i]) /
                            (2.0f + static_cast<float>(i));
            }
            const float ridge = glm::smoothstep(-0.9f, 0.7f, height01);
            const float grain = 0.1f * random.symmetric();
            *image->data(x, y) = static_cast<unsigned char>(
                255.0f * glm::clamp(glm::mix(0.5f, 0.95f, ridge) + grain, 0.0f, 1.0f));
        }
    }
    return image;
}

osg::ref_ptr<osg::Image> painted(const char* name, const osg::ref_ptr<osg::Image>& image) {
    OSG_INFO << "osgTreeWind: painted " << name << std::endl;
    return image;
}

} // namespace

osg::ref_ptr<osg::Image> bladeImage() {
    static const osg::ref_ptr<osg::Image> image = painted("blades", drawSpray());
    return image;
}

osg::ref_ptr<osg::Image> needleImage() {
    static const osg::ref_ptr<osg::Image> image = painted("needles", drawNeedles());
    return image;
}

osg::ref_ptr<osg::Image> barkImage() {
    static const osg::ref_ptr<osg::Image> image = painted("bark", drawBark());
    return image;
}

osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setName(name);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, along);
    return texture;
}

} // namespace osgTreeWind
