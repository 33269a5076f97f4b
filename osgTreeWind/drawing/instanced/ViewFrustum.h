// SPDX-License-Identifier: MIT
#pragma once

#include <osg/BoundingBox>
#include <osg/Vec4>

#include <osgUtil/CullVisitor>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace osgTreeWind {

/// The view frustum of a camera in the coordinates of the node being culled.
class ViewFrustum {
public:
    enum Side { Outside, Across, Inside };

    explicit ViewFrustum(osgUtil::CullVisitor& visitor);

    Side classify(const osg::BoundingBox& box) const;
    /// Whether the capsule of this radius around a segment may be visible; conservative near corners.
    bool intersects(const osg::Vec3& from, const osg::Vec3& to, float radius) const {
        for (std::size_t i = 0; i < _planeCount; ++i)
            if (std::max(distance(_planes[i], from), distance(_planes[i], to)) < -radius)
                return false;
        return true;
    }

    /// Height in pixels of a vertical object at a point, divided by the LOD scale; very large at the eye.
    float pixels(const osg::Vec3& point, float length) const {
        return length / std::max(std::abs(distance(_pixelSize, point)), 1.0e-9f);
    }

    const osg::Vec4* begin() const { return _planes.data(); } ///< Planes with unit normals inward.
    const osg::Vec4* end() const { return _planes.data() + _planeCount; }

private:
    static float distance(const osg::Vec4& plane, const osg::Vec3& point) {
        return plane.x() * point.x() + plane.y() * point.y() + plane.z() * point.z() + plane.w();
    }

    std::array<osg::Vec4, 32> _planes; ///< Unit normals inward; the 32 bits of OSG's mask limit their number.
    std::size_t _planeCount = 0;
    osg::Vec4 _pixelSize;
};

} // namespace osgTreeWind
