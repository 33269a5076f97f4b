// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Wire.h>

#include <cerrno>

#include <sys/socket.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

/// Without SIGPIPE, which would end a host whose reader has ended.
ssize_t put(int descriptor, const void* bytes, std::size_t size) {
    const ssize_t sent = ::send(descriptor, bytes, size, MSG_NOSIGNAL);
    return sent < 0 && errno == ENOTSOCK ? ::write(descriptor, bytes, size) : sent;
}

} // namespace

bool Wire::pass(std::string& text) {
    std::vector<char> letters(text.begin(), text.end());
    const bool good = pass(letters);
    text.assign(letters.begin(), letters.end());
    return good;
}

bool Wire::pass(bool& value) {
    unsigned char byte = value;
    const bool good = passBytes(&byte, 1) && byte <= 1;
    value = byte == 1;
    return good;
}

bool Wire::pass(Diagnostic& problem) {
    return pass(problem.file) && pass(problem.key) && pass(problem.message);
}

bool Wire::passBytes(void* bytes, std::size_t size) {
    auto* at = static_cast<char*>(bytes);
    while (size > 0) {
        const ssize_t passed = _sends ? put(_descriptor, at, size) : ::read(_descriptor, at, size);
        if (passed < 0 && errno == EINTR)
            continue;
        if (passed <= 0)
            return false;
        at += passed;
        size -= static_cast<std::size_t>(passed);
    }
    return true;
}

} // namespace osgTreeWind
