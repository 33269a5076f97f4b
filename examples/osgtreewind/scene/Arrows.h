// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <osg/Image>
#include <osg/ref_ptr>

/// A map of a wind, north up: speed as colour, from dark blue (calm) to yellow (`fastest`), with arrows
/// toward where the air goes. The lowest layer at time 0; of a plane along x or y, or a single point, what
/// there is.
/// @param low, high corners in the scene, metres.
/// @param fastest m/s.
osg::ref_ptr<osg::Image> drawArrows(const osgTreeWind::WindField& wind, const glm::dvec3& low,
                                    const glm::dvec3& high, double fastest);
