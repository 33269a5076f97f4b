// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Appearance.h>

#include <osg/Image>
#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>

#include <map>

namespace osgTreeWind {

// Images are painted or read when first asked for, by any thread, and shared: they are not to be changed.

/// Leaf cards: LeafAtlas.h says where they lie, LeafTexels.h what the channels are.
osg::ref_ptr<osg::Image> leafImage(const Appearance& appearance);
/// Bark, to be repeated along the branch and, twice, around it, where pictures of files are mirrored;
/// BarkRelief.h says what its channels are.
osg::ref_ptr<osg::Image> barkImage(const Appearance& appearance);

/// An image as a texture with mipmaps. @param along how it goes on along the branch. @param around likewise.
osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along,
                                             osg::Texture::WrapMode around = osg::Texture::CLAMP_TO_EDGE);

/// One texture for each image, for kinds of trees that share it.
class TreeTextures {
public:
    osg::Texture2D* leaves(const Appearance& appearance);
    osg::Texture2D* bark(const Appearance& appearance);

    /// Has bark, or leaves and twigs, drawn by a program, with what the appearance says but the leaves'
    /// colour.
    void showBark(osg::StateSet& state, osg::Program* program, const Appearance& appearance);
    void showLeaves(osg::StateSet& state, osg::Program* program, const Appearance& appearance);

private:
    std::map<osg::ref_ptr<osg::Image>, osg::ref_ptr<osg::Texture2D>> _textures;
};

} // namespace osgTreeWind
