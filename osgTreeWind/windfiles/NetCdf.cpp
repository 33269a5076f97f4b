// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindWire.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "OSGTREEWIND_NETCDF";

/// The program that reads NetCDF: what the environment says, else the one in osgTreeWind/ beside the library;
/// for a program into which the library was built, in the folder of libraries, installed or not.
std::string readerProgram() {
    if (const char* named = std::getenv(variable))
        return named;
    Dl_info here{};
    dladdr(&variable, &here);
    std::error_code ignored;
    fs::path object = here.dli_fname ? here.dli_fname : "", program;
    if (!object.is_absolute()) // as a program was called
        object = fs::read_symlink("/proc/self/exe", ignored);
    for (const char* libraries : {"", OSGTREEWIND_LIBRARIES_FROM_PROGRAMS, "../lib"})
        if (program = object.parent_path() / libraries / "osgTreeWind/osgtreewind-netcdf";
            fs::exists(program, ignored))
            break;
    return program;
}

/// A program that runs, and the end of the pipe into which it writes.
struct Reader {
    pid_t process = -1;
    int output = -1;
};

/// Starts it without the descriptors and the screen of this process. @return errno.
int start(const std::string& program, const std::string& path, bool asStored, Reader& reader) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return errno;
    reader.output = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::string arguments[] = {program, path, asStored ? "stored" : "grid"};
    char* argv[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), nullptr};
    const int error = posix_spawn(&reader.process, program.c_str(), &actions, nullptr, argv, environ);
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

Result<WindContent> readNetCdf(const std::string& path, bool asStored) {
    const std::string program = readerProgram();
    Reader reader;
    const int error = start(program, path, asStored, reader);
    std::optional<Result<WindContent>> content;
    if (error == 0)
        content = WindWire::receive(reader.output);
    if (reader.output >= 0)
        close(reader.output); // whoever still writes is ended by that
    if (error != 0)
        return fileProblem(path, "NetCDF needs GDAL, and the program " + program + ": " +
                                     std::generic_category().message(error));
    const std::string end = endOf(reader.process);
    if (content)
        return std::move(*content);
    return fileProblem(path, "the NetCDF file is damaged: " + end);
}

} // namespace osgTreeWind
