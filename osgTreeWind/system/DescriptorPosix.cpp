// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Descriptor.h>

#include <cerrno>

#include <sys/socket.h>
#include <unistd.h>

namespace osgTreeWind {

std::ptrdiff_t readSome(int descriptor, void* bytes, std::size_t size) {
    ssize_t count = 0;
    do
        count = read(descriptor, bytes, size);
    while (count < 0 && errno == EINTR);
    return count;
}

std::ptrdiff_t writeSome(int descriptor, const void* bytes, std::size_t size) {
    ssize_t count = 0;
    do {
        count = send(descriptor, bytes, size, MSG_NOSIGNAL);
        if (count < 0 && errno == ENOTSOCK)
            count = write(descriptor, bytes, size);
    } while (count < 0 && errno == EINTR);
    return count;
}

int takeStandardOutput() {
    const int output = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    return output;
}

bool finishOutput(int) {
    return true;
}

bool isInputTyped() {
    return isatty(STDIN_FILENO) == 1;
}

bool isErrorSeen() {
    return isatty(STDERR_FILENO) == 1;
}

} // namespace osgTreeWind
