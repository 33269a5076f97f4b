// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

#include <osgTreeWind/gpu/DrawTime.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

namespace osgTreeWind {

TreeDrawable::TreeDrawable(osg::Geometry* geometry, PosedTree* tree) : _geometry(geometry), _tree(tree) {
    setSupportsDisplayList(false);
    setDataVariance(osg::Object::DYNAMIC); // what it draws with changes every frame
}

TreeDrawable::TreeDrawable(const TreeDrawable& other, const osg::CopyOp& copyop)
    : osg::Drawable(other, copyop), _geometry(other._geometry), _tree(other._tree) {}

void TreeDrawable::accept(osg::PrimitiveFunctor& functor) const {
    const Triangles triangles = posedTriangles();
    if (triangles.indices.empty())
        return;
    functor.setVertexArray(static_cast<unsigned>(triangles.vertices.size()), triangles.vertices.data());
    functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.indices.size()),
                         triangles.indices.data());
}

void TreeDrawable::drawImplementation(osg::RenderInfo& renderInfo) const {
    if (!_geometry || !canRunPrograms(*renderInfo.getState()))
        return;
    const DrawTime time(renderInfo, "Forest draw");
    _geometry->draw(renderInfo);
}

void TreeDrawable::compileGLObjects(osg::RenderInfo& renderInfo) const {
    if (_geometry)
        _geometry->compileGLObjects(renderInfo);
}

} // namespace osgTreeWind
