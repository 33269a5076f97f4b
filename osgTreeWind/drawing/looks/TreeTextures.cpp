// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeTextures.h>

#include <osgTreeWind/drawing/looks/BarkRelief.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/TreePicture.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/observer_ptr>

#include <array>
#include <mutex>

namespace osgTreeWind {
namespace {

/// Pictures of `count` forms, each painted when first asked for, by whatever thread.
template <typename Form, std::size_t count>
class PaintedOnce {
public:
    template <typename Paint>
    osg::ref_ptr<osg::Image> image(Form form, Paint paint) {
        const auto index = static_cast<std::size_t>(form);
        std::call_once(_painted[index], [&] { _images[index] = paint(form); });
        return _images[index];
    }

private:
    std::array<std::once_flag, count> _painted;
    std::array<osg::ref_ptr<osg::Image>, count> _images;
};

/// Pictures of files, read once as long as somebody has them.
class ReadOnce {
public:
    template <typename Read>
    osg::ref_ptr<osg::Image> image(const std::string& path, Read read) {
        const std::lock_guard<std::mutex> lock(_mutex);
        osg::ref_ptr<osg::Image> image;
        if (!_images[path].lock(image))
            _images[path] = image = read(path);
        return image;
    }

private:
    std::mutex _mutex;
    std::map<std::string, osg::observer_ptr<osg::Image>> _images;
};

} // namespace

osg::ref_ptr<osg::Image> leafImage(const Appearance& appearance) {
    static ReadOnce pictures;
    if (!appearance.leafImage.empty())
        if (osg::ref_ptr<osg::Image> picture = pictures.image(appearance.leafImage, readLeafPicture))
            return picture;
    constexpr float sparse = 0.6f; // so that none shows as a whole on a bough
    static PaintedOnce<LeafForm, leafForms> images;
    return images.image(appearance.leafForm, [](LeafForm form) {
        const auto card = [&](int variant, float share) {
            return paintSpray(form, growSpray(form, variant, share));
        };
        const bool onRibs = form == LeafForm::Frond;
        const float share = onRibs ? 1.0f : sparse;
        return makeLeafAtlas({card(0, 1.0f), card(1, 1.0f), card(2, 1.0f)}, {card(0, share), card(3, share)},
                             onRibs);
    });
}

osg::ref_ptr<osg::Image> barkImage(const Appearance& appearance) {
    static ReadOnce pictures;
    if (!appearance.barkImage.empty())
        if (osg::ref_ptr<osg::Image> picture = pictures.image(appearance.barkImage, readBarkPicture))
            return picture;
    static PaintedOnce<BarkForm, static_cast<std::size_t>(BarkForm::Ringed) + 1> images;
    return images.image(appearance.barkForm, paintBark);
}

osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along, osg::Texture::WrapMode around) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setName(name);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, around);
    texture->setWrap(osg::Texture::WRAP_T, along);
    return texture;
}

osg::Texture2D* TreeTextures::leaves(const Appearance& appearance) {
    const osg::ref_ptr<osg::Image> image = leafImage(appearance);
    osg::ref_ptr<osg::Texture2D>& texture = _textures[image];
    if (!texture) {
        texture = makeTreeTexture("leaves", image, osg::Texture::CLAMP_TO_EDGE);
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST); // quick
    }
    return texture;
}

osg::Texture2D* TreeTextures::bark(const Appearance& appearance) {
    const osg::ref_ptr<osg::Image> image = barkImage(appearance);
    osg::ref_ptr<osg::Texture2D>& texture = _textures[image];
    if (!texture)
        texture = makeTreeTexture("bark", image, osg::Texture::REPEAT,
                                  appearance.barkImage.empty() ? osg::Texture::REPEAT : osg::Texture::MIRROR);
    return texture;
}

void TreeTextures::showBark(osg::StateSet& state, osg::Program* program, const Appearance& appearance) {
    state.setAttributeAndModes(program, ownProgram);
    state.setTextureAttribute(0, bark(appearance));
    state.addUniform(new osg::Uniform("barkTexture", 0));
    state.addUniform(new osg::Uniform("barkColor", toOsg(appearance.bark)));
    state.addUniform(new osg::Uniform("twigColor", toOsg(appearance.twigs())));
    drawBothSides(state); // joints are open tubes
}

void TreeTextures::showLeaves(osg::StateSet& state, osg::Program* program, const Appearance& appearance) {
    state.setAttributeAndModes(program, ownProgram);
    state.setTextureAttribute(0, leaves(appearance));
    state.addUniform(new osg::Uniform("leafTexture", 0));
    state.addUniform(new osg::Uniform("twigColor", toOsg(appearance.twigs())));
    drawBothSides(state);
}

} // namespace osgTreeWind
