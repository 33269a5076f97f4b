// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/DataTexture.h>

#include <algorithm>
#include <cstring>

namespace osgTreeWind {

DataTexture::DataTexture(const char* name, std::size_t texels)
    : _image(new osg::Image), _texture(makeFloatTexture(name)) {
    _image->allocateImage(width, rowsFor(texels), 1, GL_RGBA, GL_FLOAT);
    _image->setInternalTextureFormat(GL_RGBA32F_ARB);
    _image->setDataVariance(osg::Object::DYNAMIC);
    std::memset(_image->data(), 0, _image->getTotalSizeInBytes());

    _texture->setDataVariance(osg::Object::DYNAMIC);
    _texture->setImage(_image);
}

int DataTexture::rowsFor(std::size_t texels) {
    return static_cast<int>(std::max<std::size_t>((texels + width - 1) / width, 1));
}

osg::ref_ptr<osg::Texture2D> makeFloatTexture(const char* name) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setName(name);
    texture->setResizeNonPowerOfTwoHint(false);
    setFloatFormat(*texture);
    return texture;
}

void setFloatFormat(osg::Texture2D& texture) {
    texture.setInternalFormat(GL_RGBA32F_ARB);
    texture.setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture.setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture.setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture.setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
}

void DataTexture::write(const std::vector<glm::vec4>& texels) const {
    const std::size_t bytes =
        std::min<std::size_t>(texels.size() * sizeof(glm::vec4), _image->getTotalSizeInBytes());
    if (bytes > 0)
        std::memcpy(data(), texels.data(), bytes);
}

void bindDataTexture(osg::StateSet& state, const char* sampler, unsigned unit, osg::Texture2D* texture) {
    state.setTextureAttribute(unit, texture, osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED);
    state.getOrCreateUniform(sampler, osg::Uniform::SAMPLER_2D)->set(static_cast<int>(unit));
}

} // namespace osgTreeWind
