// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/DrawTimer.h>

#include <osg/State>
#include <osg/View>

#include <mutex>

namespace osgTreeWind {

DrawTimer::DrawTimer(osg::RenderInfo& renderInfo, const char* attribute) : _attribute(attribute) {
    osg::View* view = renderInfo.getView();
    const osg::FrameStamp* stamp = renderInfo.getState()->getFrameStamp();
    osg::Stats* stats = view ? view->getStats() : nullptr;
    if (!stamp || !stats || !stats->collectStats("update"))
        return;
    _stats = stats;
    _frame = stamp->getFrameNumber();
}

DrawTimer::~DrawTimer() {
    if (!_stats)
        return;
    static std::mutex mutex; // contexts may draw in parallel
    const std::lock_guard<std::mutex> lock(mutex);
    double before = 0.0;
    _stats->getAttribute(_frame, _attribute, before);
    _stats->setAttribute(_frame, _attribute, before + _clock.elapsedTime());
}

} // namespace osgTreeWind
