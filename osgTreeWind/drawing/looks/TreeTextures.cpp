// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeTextures.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/drawing/looks/BarkRelief.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/PaintedTexture.h>
#include <osgTreeWind/drawing/looks/PictureCache.h>
#include <osgTreeWind/drawing/looks/TreePicture.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/SharedObjects.h>

#include <osgDB/FileNameUtils>

#include <functional>
#include <string>
#include <utility>

namespace osgTreeWind {
namespace {

using SharedImages = SharedObjects<std::string, osg::Image>; ///< By kind and path, or by name.
using SharedTextures = SharedObjects<std::pair<std::string, int>, osg::Texture2D>; ///< By path and form.

/// A picture of the user's as a texture, from the cache while the file and its extension, which tells how to
/// read it, are the same.
osg::ref_ptr<osg::Image> cachedPicture(const std::string& kind, const std::string& path,
                                       osg::ref_ptr<osg::Image> (*read)(const std::string&)) {
    const std::string content = digestOfFile(path);
    if (content.empty()) {
        const osg::ref_ptr<osg::Image> image = read(path);
        if (image)
            image->setName(kind + ' ' + path);
        return image;
    }
    return cachedImage(kind + ' ' + osgDB::getLowerCaseFileExtension(path) + ' ' + content,
                       [&] { return read(path); });
}

/// The user's picture, else the painting. @param kind of pictures. @param name of the painting, in the cache.
osg::ref_ptr<osg::Image> sharedImage(SharedImages& images, const std::string& kind, const std::string& path,
                                     osg::ref_ptr<osg::Image> (*read)(const std::string&),
                                     const std::string& name,
                                     const std::function<osg::ref_ptr<osg::Image>()>& paint) {
    if (!path.empty())
        if (osg::ref_ptr<osg::Image> picture =
                images.get(kind + ' ' + path, [&] { return cachedPicture(kind, path, read); }))
            return picture;
    return images.get(name, [&] { return cachedImage(name, paint); });
}

using ImageOf = osg::ref_ptr<osg::Image> (*)(const Appearance&);

/// Makes the image of an appearance again. Null for a picture of the user's, whose file may have changed.
std::function<osg::ref_ptr<osg::Image>()> again(ImageOf image, const Appearance& appearance,
                                                const std::string& path) {
    if (!path.empty())
        return nullptr;
    return [=] { return image(appearance); };
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
    static SharedImages images;
    const LeafForm form = appearance.leafForm;
    return sharedImage(images, "leaf picture", appearance.leafImage, readLeafPicture,
                       "leaves " + std::to_string(static_cast<int>(form)), [=] { return paintLeaves(form); });
}

osg::ref_ptr<osg::Image> barkImage(const Appearance& appearance) {
    static SharedImages images;
    const BarkForm form = appearance.barkForm;
    return sharedImage(images, "bark picture", appearance.barkImage, readBarkPicture,
                       "bark " + std::to_string(static_cast<int>(form)), [=] { return paintBark(form); });
}

osg::ref_ptr<osg::Texture2D> leafTexture(const Appearance& appearance) {
    static SharedTextures textures;
    return textures.get({appearance.leafImage, static_cast<int>(appearance.leafForm)}, [&] {
        const osg::ref_ptr<osg::Texture2D> texture = makePaintedTexture(
            "leaves", leafImage(appearance), again(leafImage, appearance, appearance.leafImage),
            osg::Texture::CLAMP_TO_EDGE);
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST); // faster
        return texture;
    });
}

osg::ref_ptr<osg::Texture2D> barkTexture(const Appearance& appearance) {
    static SharedTextures textures;
    return textures.get({appearance.barkImage, static_cast<int>(appearance.barkForm)}, [&] {
        return makePaintedTexture("bark", barkImage(appearance),
                                  again(barkImage, appearance, appearance.barkImage), osg::Texture::REPEAT,
                                  appearance.barkImage.empty() ? osg::Texture::REPEAT : osg::Texture::MIRROR);
    });
}

std::vector<osg::ref_ptr<osg::Texture2D>> treeTextures(const std::vector<Species>& species,
                                                       const Executor& executor) {
    std::vector<osg::ref_ptr<osg::Texture2D>> textures(2 * species.size());
    runJobs(executor, textures.size(), [&](std::size_t i) { // leaves first, which take longer
        const bool isLeaf = i < species.size();
        const Appearance& appearance = species[i % species.size()].appearance;
        textures[i] = isLeaf ? leafTexture(appearance) : barkTexture(appearance);
    });
    return textures;
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
