// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Windows.h>

#include <algorithm>

#include <fcntl.h>
#include <io.h>

namespace osgTreeWind {

namespace {

constexpr int standardInput = 0, standardOutput = 1, standardError = 2;
constexpr std::size_t mostBytes = 1 << 20; // of one call

} // namespace

std::ptrdiff_t readSome(int descriptor, void* bytes, std::size_t size) {
    if (descriptor < 0) // runtimes may end the process
        return -1;
    return _read(descriptor, bytes, static_cast<unsigned>(std::min(size, mostBytes)));
}

std::ptrdiff_t writeSome(int descriptor, const void* bytes, std::size_t size) {
    if (descriptor < 0)
        return -1;
    return _write(descriptor, bytes, static_cast<unsigned>(std::min(size, mostBytes)));
}

int takeStandardOutput() {
    const int output = _dup(standardOutput);
    _setmode(output, _O_BINARY);
    _dup2(standardError, standardOutput);
    return output;
}

bool finishOutput(int descriptor) {
    const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
    return GetFileType(handle) != FILE_TYPE_PIPE || FlushFileBuffers(handle);
}

bool isInputTyped() {
    return _isatty(standardInput) != 0;
}

bool isErrorSeen() {
    return _isatty(standardError) != 0;
}

} // namespace osgTreeWind
