// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>
#include <osg/Texture2D>

namespace osgTreeWind {

// Textures the project draws itself, once for the whole program: the images are shared, not to be changed.
// Any thread may ask for them.

/// A spray of leaf blades on a twig, the twig running up the middle. RGBA: brightness about 0.8, alpha the
/// shape.
osg::ref_ptr<osg::Image> bladeImage();
/// A spray of needles on a twig.
osg::ref_ptr<osg::Image> needleImage();
/// Furrowed bark, grey, to be repeated along the branch and mirrored around it.
osg::ref_ptr<osg::Image> barkImage();

/// One of them as a texture with mipmaps. @param along how it goes on along the branch.
osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along);

} // namespace osgTreeWind
