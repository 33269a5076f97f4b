// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/OncePerFrame.h>

#include <osgUtil/CullVisitor>

namespace osgTreeWind {

void OncePerFrame::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getVisitorType() != osg::NodeVisitor::CULL_VISITOR || firstOfFrame(visitor))
        osg::Group::traverse(visitor);
}

bool OncePerFrame::firstOfFrame(osg::NodeVisitor& visitor) {
    auto* cull = dynamic_cast<osgUtil::CullVisitor*>(&visitor);
    if (!cull || !cull->getFrameStamp())
        return true;
    const unsigned context = cull->getState() ? cull->getState()->getContextID() : 0;
    const unsigned frame = cull->getFrameStamp()->getFrameNumber();
    const std::lock_guard<std::mutex> lock(_mutex);
    const auto found = _lastFrame.find(context);
    if (found != _lastFrame.end() && found->second == frame)
        return false;
    _lastFrame[context] = frame;
    return true;
}

} // namespace osgTreeWind
