// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/Appearance.h>

#include <osg/Image>
#include <osg/Texture2D>

namespace osgTreeWind {

// Textures the project draws itself, once for the whole program: the images are shared, not to be changed.
// Any thread may ask for them.

/// A leaf card of a form (LeafTexels.h says what its channels are), painted when first asked for.
osg::ref_ptr<osg::Image> leafImage(LeafForm form);
/// Furrowed bark, grey, to be repeated along the branch and mirrored around it.
osg::ref_ptr<osg::Image> barkImage();

/// One of them as a texture with mipmaps. @param along how it goes on along the branch.
osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along);

} // namespace osgTreeWind
