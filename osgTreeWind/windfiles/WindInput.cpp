// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindInput.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr std::size_t headSize = 1024;

} // namespace

WindInput::WindInput(const std::string& path) : _path(path), _file(openInput(path)) {
    if (!_file)
        return;
    _head.resize(headSize);
    _file.value().read(&_head[0], headSize);
    _head.resize(static_cast<std::size_t>(_file.value().gcount()));
}

Result<std::string> WindInput::head() const {
    if (!_file)
        return _file.problems();
    if (_head.empty())
        return fileProblem(_path, "the file is empty");
    return _head;
}

Result<std::string> WindInput::bytes() {
    std::ifstream& file = _file.value();
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(_path, problem);
    if (const std::string memory = problemOfMemory("its bytes", problem ? 0 : size); !memory.empty())
        return fileProblem(_path, memory);
    std::string bytes = std::move(_head);
    const std::size_t known = bytes.size();
    bytes.resize(problem ? known : std::max<std::size_t>(known, size));
    file.read(&bytes[known], static_cast<std::streamsize>(bytes.size() - known));
    if (problem || file.bad())
        return fileProblem(_path, "cannot be read");
    bytes.resize(known + static_cast<std::size_t>(file.gcount())); // less of one that is cut meanwhile
    return bytes;
}

} // namespace osgTreeWind
