// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Wire.h>

#include <osgTreeWind/system/Descriptor.h>

namespace osgTreeWind {

bool Wire::transfer(std::string& text) {
    std::vector<char> characters(text.begin(), text.end());
    const bool good = transfer(characters);
    text.assign(characters.begin(), characters.end());
    return good;
}

bool Wire::transfer(bool& value) {
    unsigned char byte = value;
    const bool good = transferBytes(&byte, 1) && byte <= 1;
    value = byte == 1;
    return good;
}

bool Wire::transfer(Diagnostic& problem) {
    return transfer(problem.file, problem.line, problem.column, problem.key, problem.message);
}

bool Wire::transferBytes(void* bytes, std::size_t size) {
    auto* at = static_cast<char*>(bytes);
    while (size > 0) {
        const std::ptrdiff_t count =
            _sends ? writeSome(_descriptor, at, size) : readSome(_descriptor, at, size);
        if (count <= 0)
            return false;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

} // namespace osgTreeWind
