// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <csignal>
#include <cstdlib>
#include <sstream>

namespace {

std::string shellQuoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

} // namespace

bool VideoWriter::available() {
    return std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
}

VideoWriter::VideoWriter(const std::string& path, int width, int height, double fps) {
    std::signal(SIGPIPE, SIG_IGN); // a failed write is reported, not fatal
    std::ostringstream command;
    command << "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s " << width << 'x' << height << " -r "
            << fps
            << " -i - -vf 'vflip,scale=trunc(iw/2)*2:trunc(ih/2)*2' -c:v libx264 -crf 18 -pix_fmt yuv420p "
            << shellQuoted("file:" + path);
    _pipe = popen(command.str().c_str(), "w");
}

VideoWriter::~VideoWriter() {
    close();
}

bool VideoWriter::write(const osg::Image& image) {
    const std::size_t size = image.getTotalSizeInBytes();
    return _pipe && std::fwrite(image.data(), 1, size, _pipe) == size;
}

bool VideoWriter::close() {
    const bool good = _pipe && pclose(_pipe) == 0;
    _pipe = nullptr;
    return good;
}
