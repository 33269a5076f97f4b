// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3>

/// Mixes two colours. @param part share of the second one.
inline osg::Vec3 mix(const osg::Vec3& a, const osg::Vec3& b, float part) {
    return a + (b - a) * part;
}
