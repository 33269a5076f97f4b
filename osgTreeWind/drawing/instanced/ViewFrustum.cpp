// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>

namespace osgTreeWind {

ViewFrustum::ViewFrustum(osgUtil::CullVisitor& visitor) {
    osg::CullingSet& culling = visitor.getCurrentCullingSet();
    // The pixel sizes of osg::CullingSet grow with the angle of view.
    const osg::Matrix &toEye = *visitor.getModelViewMatrix(), &toClip = *visitor.getProjectionMatrix();
    const osg::Matrix both = toEye * toClip;
    const double upward = osg::Vec3d(toEye(2, 0), toEye(2, 1), toEye(2, 2)).length();
    const double pixels = upward * toClip(1, 1) * 0.5 * visitor.getViewport()->height();
    _pixelSize = osg::Vec4d(both(0, 3), both(1, 3), both(2, 3), both(3, 3)) *
                 (std::max(visitor.getLODScale(), 1.0e-6f) / std::max(std::abs(pixels), 1.0e-9));
    if (!(visitor.getCullingMode() & osg::CullSettings::VIEW_FRUSTUM_SIDES_CULLING))
        return;
    unsigned bit = 1;
    for (const osg::Plane& plane : culling.getFrustum().getPlaneList()) {
        const osg::Vec4 p(plane.asVec4());
        const float length = osg::Vec3(p.x(), p.y(), p.z()).length();
        if ((culling.getFrustum().getCurrentMask() & bit) && length > 0.0f && _planeCount < _planes.size())
            _planes[_planeCount++] = p / length;
        bit <<= 1;
    }
}

ViewFrustum::Side ViewFrustum::classify(const osg::BoundingBox& box) const {
    const osg::Vec3 centre = box.center(), half = (box._max - box._min) * 0.5f;
    Side side = Inside;
    for (std::size_t i = 0; i < _planeCount; ++i) {
        const osg::Vec4& p = _planes[i];
        const float away = distance(p, centre);
        const float reach =
            std::abs(p.x()) * half.x() + std::abs(p.y()) * half.y() + std::abs(p.z()) * half.z();
        if (away < -reach)
            return Outside;
        if (away < reach)
            side = Across;
    }
    return side;
}

} // namespace osgTreeWind
