// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/Number.h>

#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Program.h>

bool VideoWriter::available() {
    return !osgTreeWind::findProgram("ffmpeg").empty();
}

VideoWriter::VideoWriter(const std::string& path, int width, int height, double fps) {
    const std::string size = std::to_string(width) + 'x' + std::to_string(height);
    // clang-format off
    const std::vector<std::string> arguments = {
        "-loglevel", "error", "-y",
        "-f", "rawvideo", "-pix_fmt", "rgba", "-s", size, "-r", osgTreeWind::numberText(fps), "-i", "-",
        "-vf", "vflip,scale=trunc(iw/2)*2:trunc(ih/2)*2", "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p",
        "-f", "mp4", "file:" + path};
    // clang-format on
    _ffmpeg.start(osgTreeWind::findProgram("ffmpeg"), arguments,
                  osgTreeWind::ChildProcess::Connection::Input);
}

VideoWriter::~VideoWriter() {
    close();
}

bool VideoWriter::write(const osg::Image& image) {
    const unsigned char* data = image.data();
    for (std::size_t left = image.getTotalSizeInBytes(); left > 0;) {
        const std::ptrdiff_t written = osgTreeWind::writeSome(_ffmpeg.descriptor(), data, left);
        if (written <= 0)
            return false;
        data += written;
        left -= static_cast<std::size_t>(written);
    }
    return true;
}

bool VideoWriter::close() {
    return _ffmpeg.finish().isSuccess;
}
