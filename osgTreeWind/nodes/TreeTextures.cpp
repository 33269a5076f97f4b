// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeTextures.h>

#include <osgTreeWind/nodes/BarkRelief.h>
#include <osgTreeWind/nodes/LeafSpray.h>

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

} // namespace

osg::ref_ptr<osg::Image> leafImage(LeafForm form) {
    static PaintedOnce<LeafForm, static_cast<std::size_t>(LeafForm::Frond) + 1> images;
    return images.image(form, [](LeafForm f) { return makeLeafImage(paintSpray(f)); });
}

osg::ref_ptr<osg::Image> barkImage(BarkForm form) {
    static PaintedOnce<BarkForm, static_cast<std::size_t>(BarkForm::Ringed) + 1> images;
    return images.image(form, paintBark);
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
