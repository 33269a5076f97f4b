// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/WholeFile.h>

#include <osg/Camera>
#include <osg/Image>

#include <memory>
#include <mutex>
#include <string>

/// Writes what a window's camera draws into clips, without text over it. While it does, each frame is a
/// twenty-fifth of a second, however long it takes.
class ClipRecorder : public osg::Camera::DrawCallback {
public:
    static constexpr double framesPerSecond = 25.0;

    /// Begins clip_0.mp4, clip_1.mp4, ... in the current folder, or ends it. @return what to tell a person.
    std::string toggle();
    /// Of the next frame. @param elapsed seconds that have passed for the person.
    double referenceTime(double elapsed);

    void operator()(osg::RenderInfo& info) const override;

private:
    mutable std::mutex _mutex; ///< Guards what follows: cameras may be drawn in a thread of theirs.
    std::string _path;         ///< Of the clip; empty: there is none.
    mutable std::unique_ptr<osgTreeWind::WholeFile> _whole;
    mutable std::unique_ptr<VideoWriter> _writer;
    mutable osg::ref_ptr<osg::Image> _image = new osg::Image;
    mutable int _frames = 0;
    double _time = 0.0, _elapsed = 0.0;
};
