// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeTextures.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/drawing/looks/BarkRelief.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/PictureCache.h>
#include <osgTreeWind/drawing/looks/TreePicture.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/SharedObjects.h>

#include <osgDB/FileNameUtils>

#include <array>
#include <mutex>
#include <string>

namespace osgTreeWind {
namespace {

/// Images of `count` forms, each painted on first use. Any thread.
template <typename Form, std::size_t count>
class ImageCache {
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

using SharedImages = SharedObjects<std::string, osg::Image>; ///< By path.
using SharedTextures = SharedObjects<const osg::Image*, osg::Texture2D>;

/// A picture of the user's as a texture, from the cache while the file and its extension, which tells how to
/// read it, are the same.
osg::ref_ptr<osg::Image> cachedPicture(const std::string& kind, const std::string& path,
                                       osg::ref_ptr<osg::Image> (*read)(const std::string&)) {
    const std::string content = digestOfFile(path);
    if (content.empty())
        return read(path);
    return cachedImage(kind + ' ' + osgDB::getLowerCaseFileExtension(path) + ' ' + content,
                       [&] { return read(path); });
}

osg::ref_ptr<osg::Image> paintLeaves(LeafForm form) {
    constexpr float sparse = 0.6f; // makes single sprays unrecognizable on a bough
    const auto card = [&](int variant, float share) {
        return paintSpray(form, growSpray(form, variant, share));
    };
    const bool onRibs = form == LeafForm::Frond;
    const float share = onRibs ? 1.0f : sparse;
    return makeLeafAtlas({card(0, 1.0f), card(1, 1.0f), card(2, 1.0f)}, {card(0, share), card(3, share)},
                         onRibs);
}

} // namespace

osg::ref_ptr<osg::Image> leafImage(const Appearance& appearance) {
    static SharedImages pictures;
    if (const std::string& path = appearance.leafImage; !path.empty())
        if (osg::ref_ptr<osg::Image> picture =
                pictures.get(path, [&] { return cachedPicture("leaf picture", path, readLeafPicture); }))
            return picture;
    static ImageCache<LeafForm, leafFormCount> images;
    return images.image(appearance.leafForm, [](LeafForm form) {
        return cachedImage("leaves " + std::to_string(static_cast<int>(form)),
                           [&] { return paintLeaves(form); });
    });
}

osg::ref_ptr<osg::Image> barkImage(const Appearance& appearance) {
    static SharedImages pictures;
    if (const std::string& path = appearance.barkImage; !path.empty())
        if (osg::ref_ptr<osg::Image> picture =
                pictures.get(path, [&] { return cachedPicture("bark picture", path, readBarkPicture); }))
            return picture;
    static ImageCache<BarkForm, static_cast<std::size_t>(BarkForm::Scaly) + 1> images;
    return images.image(appearance.barkForm, [](BarkForm form) {
        return cachedImage("bark " + std::to_string(static_cast<int>(form)), [&] { return paintBark(form); });
    });
}

std::vector<osg::ref_ptr<osg::Image>> paintImages(const std::vector<Species>& species,
                                                  const Executor& executor) {
    std::vector<osg::ref_ptr<osg::Image>> images(2 * species.size());
    runJobs(executor, images.size(), [&](std::size_t i) { // leaves first, which take longer
        const bool isLeaf = i < species.size();
        const Appearance& appearance = species[i % species.size()].appearance;
        images[i] = isLeaf ? leafImage(appearance) : barkImage(appearance);
    });
    return images;
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

osg::ref_ptr<osg::Texture2D> leafTexture(const Appearance& appearance) {
    static SharedTextures textures;
    const osg::ref_ptr<osg::Image> image = leafImage(appearance);
    return textures.get(image, [&] {
        osg::ref_ptr<osg::Texture2D> texture = makeTreeTexture("leaves", image, osg::Texture::CLAMP_TO_EDGE);
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST); // faster
        return texture;
    });
}

osg::ref_ptr<osg::Texture2D> barkTexture(const Appearance& appearance) {
    static SharedTextures textures;
    const osg::ref_ptr<osg::Image> image = barkImage(appearance);
    return textures.get(image, [&] {
        return makeTreeTexture("bark", image, osg::Texture::REPEAT,
                               appearance.barkImage.empty() ? osg::Texture::REPEAT : osg::Texture::MIRROR);
    });
}

void configureBark(osg::StateSet& state, osg::Program* program, const Appearance& appearance) {
    state.setAttributeAndModes(program, protectedProgram);
    state.setTextureAttribute(0, barkTexture(appearance));
    state.addUniform(new osg::Uniform("barkTexture", 0));
    state.addUniform(new osg::Uniform("barkColor", toOsg(appearance.bark)));
    state.addUniform(new osg::Uniform("oldBarkColor", toOsg(appearance.oldBarkColor())));
    state.addUniform(new osg::Uniform("barkAgeing", toOsg(barkAgeing(appearance.barkForm))));
    state.addUniform(new osg::Uniform("twigColor", toOsg(appearance.twigColor())));
    drawBothSides(state); // joints are open tubes
}

void configureLeaves(osg::StateSet& state, osg::Program* program, const Appearance& appearance) {
    state.setAttributeAndModes(program, protectedProgram);
    state.setTextureAttribute(0, leafTexture(appearance));
    state.addUniform(new osg::Uniform("leafTexture", 0));
    state.addUniform(new osg::Uniform("twigColor", toOsg(appearance.twigColor())));
    drawBothSides(state);
}

} // namespace osgTreeWind
