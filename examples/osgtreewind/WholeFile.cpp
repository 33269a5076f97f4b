// SPDX-License-Identifier: MIT
#include "WholeFile.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

WholeFile::WholeFile(std::string path)
    : _path(std::move(path)), _unfinished(_path + '.' + std::to_string(getpid()) + ".part") {}

WholeFile::~WholeFile() {
    if (!_unfinished.empty())
        std::remove(_unfinished.c_str());
}

bool WholeFile::putInPlace() {
    if (std::rename(_unfinished.c_str(), _path.c_str()) != 0)
        return false;
    _unfinished.clear();
    return true;
}
