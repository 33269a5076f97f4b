// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/system/ChildProcess.h>

#include <osg/Image>

#include <string>

/// Writes frames as an MP4 with the program ffmpeg.
class VideoWriter {
public:
    /// Whether ffmpeg is on the PATH.
    static bool available();

    VideoWriter(const std::string& path, int width, int height, double fps);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Adds an RGBA image of the given size. @return false if ffmpeg has exited.
    bool write(const osg::Image& image);
    /// Finishes the file. @return whether ffmpeg succeeded.
    bool close();

private:
    osgTreeWind::ChildProcess _ffmpeg;
};
