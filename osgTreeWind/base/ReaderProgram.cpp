// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProgram.h>

#include <osgTreeWind/base/Problem.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

/// Where the program is: what the environment says, else in osgTreeWind/ beside the library; for a program
/// into which the library was built, in the folder of libraries, installed or not.
std::string placeOf(const ReaderProgram& reader) {
    if (const char* named = std::getenv(reader.variable))
        return named;
    static const char inside = 0;
    Dl_info here{};
    dladdr(&inside, &here);
    std::error_code ignored;
    fs::path object = here.dli_fname ? here.dli_fname : "", program;
    if (!object.is_absolute()) // as a program was called
        object = fs::read_symlink("/proc/self/exe", ignored);
    for (const char* libraries : {"", OSGTREEWIND_LIBRARIES_FROM_PROGRAMS, "../lib"})
        if (program = object.parent_path() / libraries / "osgTreeWind" / reader.name;
            fs::exists(program, ignored))
            break;
    return program;
}

/// A program that runs, and the end of the pipe into which it writes.
struct Running {
    pid_t process = -1;
    int output = -1;
};

/// Starts it without the descriptors and the screen of this process. @return errno.
int start(std::vector<std::string> command, Running& running) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return errno;
    running.output = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::vector<char*> argv;
    for (std::string& argument : command)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int error = posix_spawn(&running.process, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    return error;
}

/// Waits for its end. @return how it came to it.
std::string endOf(pid_t process) {
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(process, &status, 0)) < 0 && errno == EINTR)
        ;
    if (ended != process) // someone else waited for it
        return "its reader ended early";
    if (!WIFSIGNALED(status))
        return "its reader ended with status " + std::to_string(WEXITSTATUS(status));
    if (WTERMSIG(status) == SIGALRM)
        return "it took its reader too long";
    const char* name = sigdescr_np(WTERMSIG(status));
    return std::string("its reader ended with: ") + (name ? name : "a signal");
}

} // namespace

std::optional<Diagnostic> runReader(const ReaderProgram& reader, const std::string& path,
                                    const std::vector<std::string>& wanted,
                                    const std::function<bool(int)>& receive) {
    const std::string program = placeOf(reader);
    Running running;
    std::vector<std::string> command = {program, path};
    command.insert(command.end(), wanted.begin(), wanted.end());
    const int error = start(std::move(command), running);
    const bool received = error == 0 && receive(running.output);
    if (running.output >= 0)
        close(running.output); // whoever still writes is ended by that
    if (error != 0)
        return fileProblem(path, std::string(reader.format) + " needs " + reader.library +
                                     ", and the program " + program + ": " +
                                     std::generic_category().message(error));
    const std::string end = endOf(running.process);
    if (received)
        return {};
    return fileProblem(path, "the " + std::string(reader.format) + " file is damaged: " + end);
}

} // namespace osgTreeWind
