// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Appearance.h>

#include <osg/Image>

namespace osgTreeWind {

/// Paints a seamless bark texture of 256 x 512 RGB texels, for half the circumference of a branch and one
/// circumference along it. Channels: brightness, height (1: outermost), hue (0.5: the species'; 1:
/// yellowish).
osg::ref_ptr<osg::Image> paintBark(BarkForm form);

} // namespace osgTreeWind
