// SPDX-License-Identifier: MIT
#include "WholeFile.h"

#include <cstdio>
#include <filesystem>

#include <unistd.h>

WholeFile::WholeFile(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path target = std::filesystem::canonical(path, problem);
    _path = problem ? path : target.string();
    _unfinished = _path + '.' + std::to_string(getpid()) + ".part";
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
