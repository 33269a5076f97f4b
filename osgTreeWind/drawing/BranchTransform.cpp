// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/BranchTransform.h>

#include <osgTreeWind/base/Range.h>

#include <cmath>
#include <string>

namespace osgTreeWind {

BranchTransform::BranchTransform() {
    setDataVariance(osg::Object::DYNAMIC);
}

BranchTransform::BranchTransform(unsigned unit, const osg::Vec3& base) : BranchTransform() {
    _unit = unit;
    const auto isInRange = [](float number) {
        return worldCoordinates.contains(static_cast<double>(number));
    };
    if (isInRange(base.x()) && isInRange(base.y()) && isInRange(base.z()))
        _base = base;
    addDescription("branch " + std::to_string(unit)); // keeps osgUtil::Optimizer from removing it while empty
}

BranchTransform::BranchTransform(const BranchTransform& other, const osg::CopyOp& copyop)
    : osg::MatrixTransform(other, copyop), _unit(other._unit), _base(other._base),
      _rotation(other._rotation) {
    setDataVariance(osg::Object::DYNAMIC);
}

void BranchTransform::setRotation(const osg::Quat& rotation) {
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(rotation._v[i]))
            return;
    _rotation = rotation;
    osg::Matrix matrix = osg::Matrix::translate(-_base);
    matrix.postMultRotate(rotation);
    matrix.postMultTranslate(_base);
    setMatrix(matrix);
}

void BranchTransform::setPose(const osg::Vec3& base, const osg::Matrix& matrix, const osg::Quat& rotation) {
    _base = base;
    _rotation = rotation;
    setMatrix(matrix);
}

} // namespace osgTreeWind
