// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindInput.h>

#include <osgTreeWind/base/Problem.h>

namespace osgTreeWind {

WindInput::WindInput(const std::string& path) : _path(path), _file(openInput(path)) {
    if (_file)
        _head = readHead(_file.value(), 1024);
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
