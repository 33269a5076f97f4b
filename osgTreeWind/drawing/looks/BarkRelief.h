// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Appearance.h>

#include <osg/Image>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Paints a seamless bark texture of 256 x 512 RGBA texels, 0.55 m wide on thick stems, and half the
/// circumference of thinner ones (shaders/bark_texture.glsl). Channels: brightness of old bark, height (1:
/// outermost), hue (0.5: the species'; 1: yellowish), brightness of young bark.
osg::ref_ptr<osg::Image> paintBark(BarkForm form);

/// At which girth and height the bark of a form is old: the parameter `ageing` of barkAge() in
/// shaders/law/tint.glsl.
glm::vec3 barkAgeing(BarkForm form);

} // namespace osgTreeWind
