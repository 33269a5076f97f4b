// SPDX-License-Identifier: MIT
#include "DefaultView.h"

#include <osg/Math>

#include <algorithm>
#include <cmath>

osg::Vec3d defaultEye(const osg::Vec3d& centre, double radius, double aspect, double fieldOfView) {
    const double halfAngle = osg::DegreesToRadians(0.5 * fieldOfView) * std::min(1.0, aspect);
    const double rise = radius < 15.0 ? 0.05 : radius < 100.0 ? 0.16 : 0.28;
    osg::Vec3d direction(-0.5, -1.0, rise);
    direction.normalize();
    return centre + direction * (0.62 * radius / std::sin(halfAngle));
}
