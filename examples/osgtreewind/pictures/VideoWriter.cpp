// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/Number.h>

#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Program.h>

#include <mutex>
#include <set>

namespace {

struct Running {
    std::mutex mutex;
    std::set<osgTreeWind::ChildProcess*> programs;
};

Running& running() {
    static Running& all = *new Running; // endAll() may be called after main()
    return all;
}

} // namespace

bool VideoWriter::available() {
    return !osgTreeWind::findProgram("ffmpeg").empty();
}

void VideoWriter::endAll() {
    running().mutex.lock(); // never unlocked, so that no other ffmpeg starts
    for (osgTreeWind::ChildProcess* program : running().programs)
        program->kill();
}

VideoWriter::VideoWriter(const std::string& path, int width, int height, double fps) {
    const std::lock_guard lock(running().mutex);
    const std::string problem = _ffmpeg.start(osgTreeWind::findProgram("ffmpeg"),
                                              {"-loglevel",
                                               "error",
                                               "-y",
                                               "-f",
                                               "rawvideo",
                                               "-pix_fmt",
                                               "rgba",
                                               "-s",
                                               std::to_string(width) + 'x' + std::to_string(height),
                                               "-r",
                                               osgTreeWind::numberText(fps),
                                               "-i",
                                               "-",
                                               "-vf",
                                               "vflip,scale=trunc(iw/2)*2:trunc(ih/2)*2",
                                               "-c:v",
                                               "libx264",
                                               "-crf",
                                               "18",
                                               "-pix_fmt",
                                               "yuv420p",
                                               "-f",
                                               "mp4",
                                               "file:" + path},
                                              osgTreeWind::ChildProcess::Connection::Input);
    if (problem.empty())
        running().programs.insert(&_ffmpeg);
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
    const bool isGood = _ffmpeg.finish().isSuccess;
    const std::lock_guard lock(running().mutex);
    running().programs.erase(&_ffmpeg);
    return isGood;
}
