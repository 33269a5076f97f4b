// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindInput.h>

#include <osgTreeWind/base/Problem.h>

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
    return readBytes(_file.value(), _path);
}

} // namespace osgTreeWind
