// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <osg/Image>
#include <osg/ref_ptr>

/// Draws a map of the lowest layer of a wind at time 0, north up: colours from dark blue (calm) to yellow
/// (`fastest`), and arrows in the direction of the air.
/// @param low, high corners in the scene, metres. @param fastest m/s.
osg::ref_ptr<osg::Image> drawArrows(const osgTreeWind::WindField& wind, const glm::dvec3& low,
                                    const glm::dvec3& high, double fastest);
