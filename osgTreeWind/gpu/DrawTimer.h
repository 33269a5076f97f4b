// SPDX-License-Identifier: MIT
#pragma once

#include <osg/RenderInfo>
#include <osg/Stats>
#include <osg/Timer>

#include <string>

namespace osgTreeWind {

/// Adds the duration of its scope, in seconds, to an attribute of the frame in the view's osg::Stats, if
/// these collect "update". Within a draw; any thread.
class DrawTimer {
public:
    DrawTimer(osg::RenderInfo& renderInfo, const char* attribute);
    DrawTimer(const DrawTimer&) = delete;
    DrawTimer& operator=(const DrawTimer&) = delete;
    ~DrawTimer();

private:
    osg::Stats* _stats = nullptr; ///< Null if they do not collect.
    unsigned _frame = 0;
    std::string _attribute;
    osg::ElapsedTime _clock;
};

} // namespace osgTreeWind
