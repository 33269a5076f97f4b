// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/DistinctArrays.h>

#include <atomic>

namespace osgTreeWind {

void makeArraysDistinct(osg::Geometry& geometry) {
    static std::atomic<unsigned> count{0};
    osg::Geometry::ArrayList arrays;
    geometry.getArrayList(arrays);
    for (const osg::ref_ptr<osg::Array>& array : arrays)
        array->setModifiedCount(++count);
}

} // namespace osgTreeWind
