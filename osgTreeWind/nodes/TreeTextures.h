// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

namespace osgTreeWind {

/// Textures the project draws itself. Each call makes the same pixels.

/// A spray of leaf blades on a twig, the twig running up the middle. RGBA: brightness about 0.8, alpha the
/// shape.
osg::ref_ptr<osg::Image> createBladeImage();
/// A spray of needles on a twig.
osg::ref_ptr<osg::Image> createNeedleImage();
/// Furrowed bark, grey, to be repeated along the branch and mirrored around it.
osg::ref_ptr<osg::Image> createBarkImage();

} // namespace osgTreeWind
