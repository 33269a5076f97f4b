// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindInput.h>

#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t headSize = 1024;

} // namespace

WindInput::WindInput(const std::string& path) : _path(path), _head(headSize, '\0') {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored))
        _file.open(path, std::ios::binary);
    _file.read(&_head[0], headSize);
    _head.resize(static_cast<std::size_t>(_file.gcount()));
}

Result<std::string> WindInput::head() const {
    if (!_file.is_open())
        return fileProblem(_path, "cannot be read");
    if (_head.empty())
        return fileProblem(_path, "the file is empty");
    return _head;
}

std::string WindInput::bytes() {
    std::error_code unknown; // of a pipe, say
    const auto size = fs::file_size(_path, unknown);
    std::string bytes = std::move(_head);
    std::size_t known = bytes.size();
    if (!unknown && size > known)
        bytes.resize(static_cast<std::size_t>(size));
    while (_file && _file.peek() != std::ifstream::traits_type::eof()) {
        if (known == bytes.size())
            bytes.resize(2 * known);
        _file.read(&bytes[known], static_cast<std::streamsize>(bytes.size() - known));
        known += static_cast<std::size_t>(_file.gcount());
    }
    bytes.resize(known);
    return bytes;
}

Result<std::string> readBytes(const std::string& path) {
    WindInput input(path);
    const Result<std::string> head = input.head();
    if (!head)
        return head.problems();
    return input.bytes();
}

} // namespace osgTreeWind
