// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <cstdio>
#include <string>

/// Writes frames as an MP4 through the ffmpeg program.
class VideoWriter {
public:
    /// Whether ffmpeg is on the PATH.
    static bool available();

    VideoWriter(const std::string& path, int width, int height, double fps);
    ~VideoWriter();

    /// Adds an RGBA image of the given size. @return false when ffmpeg has gone.
    bool write(const osg::Image& image);
    /// Ends the file. @return whether ffmpeg succeeded.
    bool close();

private:
    std::FILE* _pipe;
};
