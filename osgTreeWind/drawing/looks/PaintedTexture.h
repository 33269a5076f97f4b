// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>
#include <osg/Texture2D>

#include <functional>

namespace osgTreeWind {

/// Makes a texture that keeps no image after OpenGL has it; getImage() is null. It has the size and the
/// mipmaps of the image.
/// @param image given to the first context that uses the texture, and kept until then.
/// @param again makes the same image for other contexts and after releaseGLObjects(), in any thread. If null,
/// the texture keeps a compressed copy of the image instead, which must be RGBA8.
osg::ref_ptr<osg::Texture2D> makeLoadedTexture(const char* name, osg::Image* image,
                                               std::function<osg::ref_ptr<osg::Image>()> again);

/// Makes such a texture for an RGBA8 picture with mipmaps.
/// @param along wrap mode along the branch (v). @param around the branch (u).
osg::ref_ptr<osg::Texture2D> makePaintedTexture(const char* name, osg::Image* image,
                                                std::function<osg::ref_ptr<osg::Image>()> again,
                                                osg::Texture::WrapMode along,
                                                osg::Texture::WrapMode around = osg::Texture::CLAMP_TO_EDGE);

} // namespace osgTreeWind
