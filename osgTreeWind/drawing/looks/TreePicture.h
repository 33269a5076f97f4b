// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

namespace osgTreeWind {

// Image files as leaf and bark textures. Brightness and hue are relative to their means, since the species
// sets the colour. Reads all formats of osgDB. Returns null, with a warning, for a file that cannot be read.

/// Reads a picture of a spray, whose alpha is its shape, as a leaf texture (LeafAtlas) of three equal sprays
/// of 256 x 256 texels without twigs.
osg::ref_ptr<osg::Image> readLeafPicture(const std::string& path);
/// Reads a picture of half the circumference of a branch as a bark texture (BarkRelief.h) of 256 x 512
/// texels. Height follows brightness.
osg::ref_ptr<osg::Image> readBarkPicture(const std::string& path);

} // namespace osgTreeWind
