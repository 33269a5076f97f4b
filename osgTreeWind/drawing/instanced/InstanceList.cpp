// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstanceList.h>

namespace osgTreeWind {

InstanceList::InstanceList() : values(new osg::FloatArray) {
    osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    buffer->setUsage(GL_STREAM_DRAW_ARB);
    values->setVertexBufferObject(buffer);
}

void InstanceList::add(const TreeInstance& tree) {
    const float* first = tree.place;
    values->insert(values->end(), first, first + sizeof tree / sizeof(float));
}

void InstanceList::clear() {
    values->clear();
    passes = nullptr;
    page = nullptr;
}

} // namespace osgTreeWind
