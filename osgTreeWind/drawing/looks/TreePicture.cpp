// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreePicture.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Srgb.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/PictureSize.h>

#include <osg/Notify>
#include <osgDB/ReadFile>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {
namespace {

constexpr float leafBrightness = 0.8f, barkBrightness = 0.74f; // means of the built-in textures

/// A resized image: linear colours and alpha.
struct Pixels {
    int width, height;
    std::vector<glm::vec4> colors;
    glm::vec3 mean{1e-4f}; ///< Weighted by alpha.
};

/// Mean of 4 x 4 samples in a pixel.
glm::vec4 pixelOf(const osg::Image& image, int x, int y, int width, int height) {
    constexpr int samples = 4;
    glm::vec3 color(0.0f);
    float alpha = 0.0f;
    for (int i = 0; i < samples * samples; ++i) {
        const int s = (samples * x + i % samples) * image.s() / (samples * width),
                  t = (samples * y + i / samples) * image.t() / (samples * height);
        const osg::Vec4 c = image.getColor(static_cast<unsigned>(s), static_cast<unsigned>(t));
        color += c.a() * glm::vec3(linearOfSrgb(c.r()), linearOfSrgb(c.g()), linearOfSrgb(c.b()));
        alpha += c.a();
    }
    return {alpha > 0.0f ? color / alpha : glm::vec3(0.0f), alpha / (samples * samples)};
}

/// Why a picture must not be read; empty if it may.
std::string problemOfPicture(const std::string& path) {
    Result<std::ifstream> file = openInput(path);
    const std::optional<glm::dvec2> size = file ? pictureSize(file.value()) : std::nullopt;
    constexpr double maxPixelBytes = 8.0; // four channels of 16 bits
    return size ? problemOfMemory("its pixels", static_cast<std::uint64_t>(maxPixelBytes * size->x * size->y))
                : std::string();
}

Pixels readPixels(const std::string& path, int width, int height) {
    Pixels pixels{width, height, {}};
    if (const std::string problem = problemOfPicture(path); !problem.empty()) {
        OSG_WARN << "osgTreeWind: \"" << path << "\": " << problem << std::endl;
        return pixels;
    }
    const osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(path);
    if (!image || !image->data() || image->s() < 1 || image->t() < 1 || image->isCompressed()) {
        OSG_WARN << "osgTreeWind: OpenSceneGraph cannot read \"" << path << "\" as "
                 << (image && image->isCompressed() ? "an uncompressed" : "a")
                 << " picture; the built-in texture is shown" << std::endl;
        return pixels;
    }
    glm::vec4 sum(0.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec4 pixel = pixelOf(*image, x, y, width, height);
            sum += glm::vec4(pixel.a * glm::vec3(pixel), pixel.a);
            pixels.colors.push_back(pixel);
        }
    pixels.mean = glm::max(glm::vec3(sum) / glm::max(sum.a, 1e-4f), 1e-4f);
    return pixels;
}

float brightness(const glm::vec4& pixel, const Pixels& pixels, float mean) {
    return glm::min(mean * luminance(glm::vec3(pixel)) / luminance(pixels.mean), 1.0f);
}

/// The hue of law/tint.glsl: 0 bluish, 0.5 the mean, 1 yellowish.
float hue(const glm::vec4& pixel, const Pixels& pixels) {
    const float yellow = (pixel.r + 1e-3f) / (pixel.b + 1e-3f) * pixels.mean.b / pixels.mean.r;
    return glm::clamp(0.5f + (yellow - 1.0f), 0.0f, 1.0f);
}

} // namespace

osg::ref_ptr<osg::Image> readLeafPicture(const std::string& path) {
    LeafTexels leaf(256);
    const Pixels pixels = readPixels(path, leaf.size, leaf.size);
    for (std::size_t i = 0; i < pixels.colors.size(); ++i) {
        const glm::vec4& pixel = pixels.colors[i];
        leaf.texels[i] = pixel.a > 0.0f ? glm::vec4(brightness(pixel, pixels, leafBrightness),
                                                    hue(pixel, pixels), 0.0f, pixel.a)
                                        : glm::vec4(leafBrightness, 0.5f, 0.0f, 0.0f);
    }
    return pixels.colors.empty() ? nullptr : makeLeafAtlas({leaf, leaf, leaf}, {leaf});
}

osg::ref_ptr<osg::Image> readBarkPicture(const std::string& path) {
    const Pixels pixels = readPixels(path, 256, 512);
    if (pixels.colors.empty())
        return nullptr;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(pixels.width, pixels.height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (std::size_t i = 0; i < pixels.colors.size(); ++i) {
        const float light = brightness(pixels.colors[i], pixels, barkBrightness);
        const glm::vec4 texel{light, light, hue(pixels.colors[i], pixels), light};
        for (int channel = 0; channel < 4; ++channel)
            image->data()[4 * i + static_cast<std::size_t>(channel)] = byteOf(texel[channel]);
    }
    return image;
}

} // namespace osgTreeWind
