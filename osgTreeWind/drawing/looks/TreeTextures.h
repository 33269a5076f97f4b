// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Appearance.h>

#include <osg/Image>
#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>

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

/// leafImage() as a texture, the same one for all who hold it. Any thread.
osg::ref_ptr<osg::Texture2D> leafTexture(const Appearance& appearance);
/// Likewise barkImage().
osg::ref_ptr<osg::Texture2D> barkTexture(const Appearance& appearance);

/// Has bark drawn by a program, with what the appearance says.
void showBark(osg::StateSet& state, osg::Program* program, const Appearance& appearance);
/// The same for leaves and twigs, but for the leaves' colour.
void showLeaves(osg::StateSet& state, osg::Program* program, const Appearance& appearance);

} // namespace osgTreeWind
