// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

namespace osgTreeWind {

// Pictures from files as our own textures are: brightness and hue about their means, for the colour is the
// species'. Whatever osgDB reads; null, and a warning, where it cannot.

/// A picture of a spray whose alpha is its shape: 256 x 256, without twigs of its own.
osg::ref_ptr<osg::Image> readLeafPicture(const std::string& path);
/// A picture of bark, half way around a branch: 256 x 512. What is brighter lies farther out.
osg::ref_ptr<osg::Image> readBarkPicture(const std::string& path);

} // namespace osgTreeWind
