// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/WholeFile.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

namespace osgTreeWind {

WholeFile::WholeFile(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path target = std::filesystem::canonical(path, problem);
    _path = problem ? path : target.string();
    // Processes of two machines or containers may have one number.
    _unfinished =
        _path + '.' + std::to_string(getpid()) + '-' + std::to_string(std::random_device()()) + ".part";
}

WholeFile::~WholeFile() {
    if (!_unfinished.empty())
        std::remove(_unfinished.c_str());
}

bool WholeFile::isTaken() const {
    std::error_code ignored;
    return std::filesystem::exists(_path, ignored) && !std::filesystem::is_regular_file(_path, ignored);
}

bool WholeFile::putInPlace() {
    if (std::rename(_unfinished.c_str(), _path.c_str()) != 0)
        return false;
    _unfinished.clear();
    return true;
}

bool writeWholeFile(const std::string& path, const std::string& text) {
    WholeFile file(path);
    const std::string& place = file.isTaken() ? path : file.unfinished();
    if (!(std::ofstream(place, std::ios::binary) << text).flush())
        return false;
    return file.isTaken() || file.putInPlace();
}

} // namespace osgTreeWind
