// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeTextures.h>

#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/nodes/LeafSpray.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <mutex>

namespace osgTreeWind {
namespace {

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

} // namespace

osg::ref_ptr<osg::Image> leafImage(LeafForm form) {
    constexpr std::size_t forms = static_cast<std::size_t>(LeafForm::Frond) + 1;
    static std::array<std::once_flag, forms> painted;
    static std::array<osg::ref_ptr<osg::Image>, forms> images;
    const auto index = static_cast<std::size_t>(form);
    std::call_once(painted[index], [&] { images[index] = makeLeafImage(paintSpray(form)); });
    return images[index];
}

osg::ref_ptr<osg::Image> barkImage() {
    static const osg::ref_ptr<osg::Image> image = drawBark();
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
