// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/Number.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <set>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct Running {
    std::mutex mutex;
    std::set<pid_t> programs;
};

Running& running() {
    static Running& all = *new Running; // endAll() may be called after main()
    return all;
}

/// Starts ffmpeg with a pipe as its input. @return the end to write to, or -1 on failure.
int startFfmpeg(const std::vector<std::string>& words, pid_t& program) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return -1;
    std::vector<char*> argv;
    for (const std::string& word : words)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    const bool isStarted = posix_spawnp(&program, argv[0], &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    if (isStarted)
        return ends[1];
    ::close(ends[1]);
    return -1;
}

} // namespace

bool VideoWriter::available() {
    return std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
}

void VideoWriter::endAll() {
    running().mutex.lock(); // never unlocked, so that no other ffmpeg starts
    for (const pid_t program : running().programs) {
        kill(program, SIGKILL);
        waitpid(program, nullptr, 0);
    }
}

VideoWriter::VideoWriter(const std::string& path, int width, int height, double fps) {
    std::signal(SIGPIPE, SIG_IGN); // a failed write is reported, not fatal
    const std::lock_guard lock(running().mutex);
    _pipe = startFfmpeg({"ffmpeg",      "-loglevel",
                         "error",       "-y",
                         "-f",          "rawvideo",
                         "-pix_fmt",    "rgba",
                         "-s",          std::to_string(width) + 'x' + std::to_string(height),
                         "-r",          osgTreeWind::numberText(fps),
                         "-i",          "-",
                         "-vf",         "vflip,scale=trunc(iw/2)*2:trunc(ih/2)*2",
                         "-c:v",        "libx264",
                         "-crf",        "18",
                         "-pix_fmt",    "yuv420p",
                         "-f",          "mp4",
                         "file:" + path},
                        _ffmpeg);
    if (_pipe >= 0)
        running().programs.insert(_ffmpeg);
}

VideoWriter::~VideoWriter() {
    close();
}

bool VideoWriter::write(const osg::Image& image) {
    const unsigned char* data = image.data();
    for (std::size_t left = image.getTotalSizeInBytes(); left > 0;) {
        const ssize_t written = ::write(_pipe, data, left);
        if (written < 0 && errno != EINTR)
            return false;
        data += std::max<ssize_t>(written, 0);
        left -= static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    return true;
}

bool VideoWriter::close() {
    if (_pipe < 0)
        return false;
    ::close(_pipe);
    _pipe = -1;
    int status = -1;
    while (waitpid(_ffmpeg, &status, 0) < 0 && errno == EINTR)
        ;
    const std::lock_guard lock(running().mutex);
    running().programs.erase(_ffmpeg);
    return status == 0;
}
