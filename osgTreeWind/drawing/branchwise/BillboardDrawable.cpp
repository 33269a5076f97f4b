// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/BillboardDrawable.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgTreeWind {

osg::BoundingBox BillboardDrawable::computeBoundingBox() const {
    return _tree ? _tree->bounds() : osg::BoundingBox();
}

void BillboardDrawable::drawImplementation(osg::RenderInfo& renderInfo) const {
    if (!_tree)
        return;
    const TreeScale& scale = _tree->scale();
    const auto* gl = renderInfo.getState()->get<osg::GLExtensions>();
    gl->glVertexAttrib4f(treePlaceLocation, 0.0f, 0.0f, 0.0f, 0.0f);
    gl->glVertexAttrib4f(treeSizeLocation, scale.axes.x, scale.axes.z, 0.0f, 0.0f);
    gl->glVertexAttrib4f(treeStateLocation, 0.0f, 0.0f, 1.0f, _ownNumber);
    TreeDrawable::drawImplementation(renderInfo);
}

} // namespace osgTreeWind
