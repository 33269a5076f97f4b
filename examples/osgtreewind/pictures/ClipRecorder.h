// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/AtomicFile.h>

#include <osg/Camera>
#include <osg/Image>

#include <memory>
#include <mutex>
#include <string>

/// Records what the camera of a window draws, without its text, as MP4 clips. While it records, each frame
/// advances the time by 1/25 s, however long it takes.
class ClipRecorder : public osg::Camera::DrawCallback {
public:
    static constexpr double framesPerSecond = 25.0;

    /// Starts clip_0.mp4, clip_1.mp4, ... in the current folder, or stops it. @return message for the user.
    std::string toggle();
    /// Time of the next frame, s. @param elapsed real time since the start, s.
    double referenceTime(double elapsed);

    void operator()(osg::RenderInfo& info) const override;

private:
    mutable std::mutex _mutex; ///< Guards the members below: a camera may be drawn in its own thread.
    std::string _path;         ///< Path of the current clip; empty if none is recorded.
    mutable std::unique_ptr<osgTreeWind::AtomicFile> _whole;
    mutable std::unique_ptr<VideoWriter> _writer;
    mutable osg::ref_ptr<osg::Image> _image = new osg::Image;
    mutable int _frames = 0;
    double _time = 0.0, _elapsed = 0.0;
};
