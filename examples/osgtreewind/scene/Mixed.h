// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3>

/// Of two colours, `part` of the second.
inline osg::Vec3 mixed(const osg::Vec3& a, const osg::Vec3& b, float part) {
    return a + (b - a) * part;
}
