// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/Appearance.h>

#include <osg/Image>
#include <osg/Texture2D>

#include <glm/vec3.hpp>

namespace osgTreeWind {

// Textures the project draws itself, once for the whole program: the images are shared, not to be changed.
// Any thread may ask for them.

/// A leaf card of a form (LeafTexels.h says what its channels are), painted when first asked for.
osg::ref_ptr<osg::Image> leafImage(LeafForm form);
/// Bark of a form (BarkRelief.h), to be repeated along the branch and mirrored around it.
osg::ref_ptr<osg::Image> barkImage(BarkForm form);

/// What a texel reflects over the colour of leaves or bark: its brightness, and its hue from bluish to
/// yellowish. As shaders/texel_tint.glsl.
inline glm::vec3 texelTint(float brightness, float hue) {
    return brightness * (1.0f + (hue - 0.5f) * glm::vec3(0.5f, 0.1f, -0.4f));
}

/// One of them as a texture with mipmaps. @param along how it goes on along the branch.
osg::ref_ptr<osg::Texture2D> makeTreeTexture(const char* name, osg::Image* image,
                                             osg::Texture::WrapMode along);

} // namespace osgTreeWind
