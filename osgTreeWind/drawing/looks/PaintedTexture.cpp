// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/PaintedTexture.h>

#include <osgTreeWind/drawing/looks/PictureCache.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace osgTreeWind {
namespace {

std::function<osg::ref_ptr<osg::Image>()> fromCompressed(const osg::Image& image) {
    auto bytes = std::make_shared<std::string>();
    appendImage(image, *bytes);
    bytes->shrink_to_fit();
    return [bytes = std::shared_ptr<const std::string>(std::move(bytes))] {
        std::size_t place = 0;
        return takeImage(*bytes, place);
    };
}

class ImageLoader : public osg::Texture2D::SubloadCallback {
public:
    ImageLoader(osg::Image* image, std::function<osg::ref_ptr<osg::Image>()> again)
        : _image(again ? image : nullptr), _again(again ? std::move(again) : fromCompressed(*image)) {}

    void load(const osg::Texture2D& texture, osg::State& state) const override {
        _guard.run("a texture of trees is missing", [&] {
            osg::ref_ptr<osg::Image> image = takeImage();
            if (!image)
                image = _again();
            if (!image)
                return;
            texture.applyTexImage2D_load(state, GL_TEXTURE_2D, image, image->s(), image->t(),
                                         static_cast<GLsizei>(image->getNumMipmapLevels()));
        });
    }
    void subload(const osg::Texture2D&, osg::State&) const override {}

private:
    osg::ref_ptr<osg::Image> takeImage() const {
        const std::lock_guard<std::mutex> lock(_mutex);
        return std::exchange(_image, nullptr);
    }

    mutable std::mutex _mutex;
    mutable osg::ref_ptr<osg::Image> _image; ///< Guarded by `_mutex`.
    std::function<osg::ref_ptr<osg::Image>()> _again;
    ExceptionGuard _guard;
};

/// OSG sets all parameters of a texture with a callback again at each use.
class LoadedTexture : public osg::Texture2D {
public:
    void apply(osg::State& state) const override {
        const unsigned context = state.getContextID();
        TextureObject* loaded = getTextureObject(context);
        if (!loaded || getTextureParameterDirty(context))
            return osg::Texture2D::apply(state);
        loaded->bind();
    }
};

} // namespace

osg::ref_ptr<osg::Texture2D> makeLoadedTexture(const char* name, osg::Image* image,
                                               std::function<osg::ref_ptr<osg::Image>()> again) {
    osg::ref_ptr<osg::Texture2D> texture = new LoadedTexture;
    texture->setName(name);
    texture->setTextureSize(image->s(), image->t());
    texture->setNumMipmapLevels(image->getNumMipmapLevels());
    texture->setSubloadCallback(new ImageLoader(image, std::move(again)));
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

osg::ref_ptr<osg::Texture2D> makePaintedTexture(const char* name, osg::Image* image,
                                                std::function<osg::ref_ptr<osg::Image>()> again,
                                                osg::Texture::WrapMode along, osg::Texture::WrapMode around) {
    osg::ref_ptr<osg::Texture2D> texture = makeLoadedTexture(name, image, std::move(again));
    texture->setInternalFormat(GL_RGBA);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, around);
    texture->setWrap(osg::Texture::WRAP_T, along);
    return texture;
}

} // namespace osgTreeWind
