// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/ChildProcess.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

/// Does not release the process, so that no other process gets its number.
void awaitEndOf(std::intptr_t process) {
    siginfo_t end;
    while (waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOWAIT) != 0 && errno == EINTR)
        ;
}

} // namespace

std::string ChildProcess::startProgram(const std::string& program, const std::vector<std::string>& arguments,
                                       Connection connection) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return std::generic_category().message(errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    if (connection == Connection::InputAndOutput) {
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::vector<std::string> words = {program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t process = -1;
    const int error = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error != 0) {
        close(ends[0]);
        return std::generic_category().message(error);
    }
    _process = process;
    _descriptor = ends[0];
    return {};
}

void ChildProcess::awaitEnd() {
    close(_descriptor);
    _descriptor = -1;
    awaitEndOf(_process);
}

ChildProcess::End ChildProcess::takeEnd() {
    const auto process = static_cast<pid_t>(_process);
    _process = -1;
    int status = 0;
    if (waitpid(process, &status, 0) != process) // the host reaped it
        return {false, "ended early"};
    if (!WIFSIGNALED(status))
        return {status == 0, "ended with status " + std::to_string(WEXITSTATUS(status))};
    if (WTERMSIG(status) == SIGALRM)
        return {false, "timed out"};
    const char* name = sigdescr_np(WTERMSIG(status));
    return {false, std::string("ended with: ") + (name ? name : "a signal")};
}

void ChildProcess::kill() {
    if (_process < 0)
        return;
    ::kill(static_cast<pid_t>(_process), SIGKILL);
    awaitEndOf(_process);
}

} // namespace osgTreeWind
