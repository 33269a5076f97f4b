// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Appearance.h>

#include <osg/Image>

namespace osgTreeWind {

/// Paints bark: 256 x 512 RGB, half way around a branch by once its circumference along it. Brightness,
/// height (1: outermost), hue (0.5: as the species' bark; more: yellowish). Goes on without a seam around
/// and along the branch.
osg::ref_ptr<osg::Image> paintBark(BarkForm form);

} // namespace osgTreeWind
