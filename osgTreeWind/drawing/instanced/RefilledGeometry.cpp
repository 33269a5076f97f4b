// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/RefilledGeometry.h>

#include <osg/State>

#include <cstring>
#include <utility>

namespace osgTreeWind {
namespace {

void copyBytes(const osg::BufferData& from, osg::BufferData& to) {
    std::memcpy(const_cast<GLvoid*>(to.getDataPointer()), from.getDataPointer(), from.getTotalDataSize());
}

} // namespace

RefilledGeometry::RefilledGeometry(osg::Geometry& full, Maker again) : _again(std::move(again)) {
    setName(full.getName());
    for (unsigned i = 0; i < full.getNumVertexAttribArrays(); ++i)
        if (full.getVertexAttribArray(i))
            setVertexAttribArray(i, full.getVertexAttribArray(i));
    addPrimitiveSet(full.getPrimitiveSet(0));
    getArrayList(_arrays);
    _elements = getPrimitiveSet(0)->getDrawElements();
}

void RefilledGeometry::fillBuffers(osg::State& state) const {
    const unsigned context = state.getContextID();
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!isMissing(context))
        return;
    refill();
    unbindVertices(state); // indices would be bound to the vertex array object of another geometry
    state.bindVertexBufferObject(_arrays.front()->getOrCreateGLBufferObject(context));
    state.bindElementBufferObject(_elements->getOrCreateGLBufferObject(context));
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    empty();
}

void RefilledGeometry::compileGLObjects(osg::RenderInfo& renderInfo) const {
    const std::lock_guard<std::mutex> lock(_mutex);
    if (isMissing(renderInfo.getContextID()))
        refill();
    SceneGeometry::compileGLObjects(renderInfo);
    empty();
}

bool RefilledGeometry::isMissing(unsigned context) const {
    for (const osg::BufferData* data :
         {static_cast<osg::BufferData*>(_arrays.front()), static_cast<osg::BufferData*>(_elements)}) {
        const osg::GLBufferObject* buffer = data->getGLBufferObject(context);
        if (!buffer || buffer->isDirty())
            return true;
    }
    return false;
}

void RefilledGeometry::refill() const {
    if (_elements->getNumIndices() > 0)
        return;
    const osg::ref_ptr<osg::Geometry> made = _again();
    ArrayList arrays;
    made->getArrayList(arrays);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        _arrays[i]->resizeArray(arrays[i]->getNumElements());
        copyBytes(*arrays[i], *_arrays[i]);
    }
    const osg::DrawElements& elements = *made->getPrimitiveSet(0)->getDrawElements();
    _elements->resizeElements(elements.getNumIndices());
    copyBytes(elements, *_elements);
}

void RefilledGeometry::empty() const {
    for (const osg::ref_ptr<osg::Array>& array : _arrays) {
        array->resizeArray(0);
        array->trim();
    }
    const auto clear = [&](auto* indices) {
        if (indices)
            std::decay_t<decltype(indices->asVector())>().swap(indices->asVector());
    };
    clear(dynamic_cast<osg::DrawElementsUShort*>(_elements.get()));
    clear(dynamic_cast<osg::DrawElementsUInt*>(_elements.get()));
}

} // namespace osgTreeWind
