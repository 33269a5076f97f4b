// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProcess.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

/// The path of the program: the environment variable, or else osgTreeWind/ beside the library. A program that
/// links the library statically searches beside itself, then the folders of the installation and the build.
std::string findProgram(const ReaderProgram& reader) {
    if (const char* path = std::getenv(reader.variable))
        return path;
    static const char symbol = 0;
    Dl_info info{};
    dladdr(&symbol, &info);
    std::error_code ignored;
    fs::path object = info.dli_fname ? info.dli_fname : "";
    if (!object.is_absolute()) // argv[0] of a statically linked program
        object = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path folder = object.parent_path(), name = fs::path("osgTreeWind") / reader.name;
    for (const char* libraries : {"", OSGTREEWIND_LIBRARY_FOLDERS}) // relative to the object or absolute
        if (fs::exists(folder / libraries / name, ignored))
            return folder / libraries / name;
    return folder / name;
}

/// Starts a program whose standard input and output are one end of a socket. It inherits no other
/// descriptors, and its standard error is discarded. @return 0 or an errno value.
int startProgram(const std::string& program, const std::vector<std::string>& arguments, pid_t& process,
                 int& descriptor) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return errno;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::vector<std::string> words = {program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const int error = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (error == 0)
        descriptor = ends[0];
    else
        ::close(ends[0]);
    return error;
}

/// Waits for the process to exit. @return the reason for the exit.
std::string waitForExit(pid_t process) {
    int status = 0;
    pid_t waited = 0;
    while ((waited = waitpid(process, &status, 0)) < 0 && errno == EINTR)
        ;
    if (waited != process) // the host reaped it
        return "its reader ended early";
    if (!WIFSIGNALED(status))
        return "its reader ended with status " + std::to_string(WEXITSTATUS(status));
    if (WTERMSIG(status) == SIGALRM)
        return "its reader timed out";
    const char* name = sigdescr_np(WTERMSIG(status));
    return std::string("its reader ended with: ") + (name ? name : "a signal");
}

} // namespace

ReaderProcess::ReaderProcess(const ReaderProgram& reader, const std::vector<std::string>& arguments) {
    const std::string program = findProgram(reader);
    if (const int error = startProgram(program, arguments, _process, _descriptor); error != 0)
        _startProblem = std::string(reader.format) + " needs " + reader.library + ", and the program " +
                        program + ": " + std::generic_category().message(error);
}

ReaderProcess::~ReaderProcess() {
    close();
}

void ReaderProcess::close() {
    if (_descriptor < 0)
        return;
    ::close(_descriptor); // ends a program that is writing or waiting for a request
    _descriptor = -1;
    _exitReason = waitForExit(_process);
}

std::string ReaderProcess::problem() {
    close();
    return _startProblem.empty() ? _exitReason : _startProblem;
}

} // namespace osgTreeWind
