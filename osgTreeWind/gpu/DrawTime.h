// SPDX-License-Identifier: MIT
#pragma once

#include <osg/RenderInfo>
#include <osg/Stats>
#include <osg/Timer>

#include <string>

namespace osgTreeWind {

/// Adds the seconds of its life to an attribute of a frame in the view's osg::Stats, where somebody collects
/// "update". Within a draw; any thread.
class DrawTime {
public:
    DrawTime(osg::RenderInfo& renderInfo, const char* attribute);
    DrawTime(const DrawTime&) = delete;
    DrawTime& operator=(const DrawTime&) = delete;
    ~DrawTime();

private:
    osg::Stats* _stats = nullptr; ///< Null: nobody collects.
    unsigned _frame = 0;
    std::string _attribute;
    osg::ElapsedTime _clock;
};

} // namespace osgTreeWind
