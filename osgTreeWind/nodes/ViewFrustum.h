// SPDX-License-Identifier: MIT
#pragma once

#include <osg/BoundingBox>
#include <osg/Vec4>

#include <osgUtil/CullVisitor>

#include <vector>

namespace osgTreeWind {

/// What a camera sees, in the frame of the node that it culls.
class ViewFrustum {
public:
    enum Side { Outside, Across, Inside };

    explicit ViewFrustum(osgUtil::CullVisitor& visitor);

    Side sideOf(const osg::BoundingBox& box) const;
    bool sees(const osg::Vec3& centre, float radius) const {
        for (const osg::Vec4& plane : _planes)
            if (plane.x() * centre.x() + plane.y() * centre.y() + plane.z() * centre.z() + plane.w() < -radius)
                return false;
        return true;
    }

    /// Pixels that a length covers about a point, LOD scale included; huge near the eye.
    float pixels(const osg::Vec3& point, float length) const {
        const float size = std::abs(_pixelSize.x() * point.x() + _pixelSize.y() * point.y() +
                                    _pixelSize.z() * point.z() + _pixelSize.w());
        return length / std::max(size, 1.0e-9f);
    }

private:
    std::vector<osg::Vec4> _planes; ///< Unit normals inward.
    osg::Vec4 _pixelSize;
};

} // namespace osgTreeWind
