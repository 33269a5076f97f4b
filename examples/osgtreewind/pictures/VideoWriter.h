// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

#include <sys/types.h>

/// Writes frames as an MP4 through the ffmpeg program.
class VideoWriter {
public:
    /// Whether ffmpeg is on the PATH.
    static bool available();
    /// Ends the ffmpeg of every writer: their files stay unfinished.
    static void endAll();

    VideoWriter(const std::string& path, int width, int height, double fps);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Adds an RGBA image of the given size. @return false when ffmpeg has gone.
    bool write(const osg::Image& image);
    /// Ends the file. @return whether ffmpeg succeeded.
    bool close();

private:
    pid_t _ffmpeg = -1;
    int _pipe = -1;
};
