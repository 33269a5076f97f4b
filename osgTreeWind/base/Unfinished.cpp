// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Unfinished.h>

#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

namespace osgTreeWind {
namespace {

struct All {
    std::mutex mutex;
    std::set<std::string> paths;
};

All& all() {
    static All& everything = *new All; // threads may outlive main()
    return everything;
}

void remove(const std::string& path) {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

} // namespace

Unfinished::Unfinished(std::string path) : _path(std::move(path)) {
    const std::lock_guard lock(all().mutex);
    all().paths.insert(_path);
}

Unfinished::~Unfinished() {
    const std::lock_guard lock(all().mutex);
    if (all().paths.erase(_path) > 0)
        remove(_path);
}

void Unfinished::finish() {
    const std::lock_guard lock(all().mutex);
    all().paths.erase(_path);
}

bool Unfinished::finishAs(const std::string& path) {
    const std::lock_guard lock(all().mutex);
    if (std::rename(_path.c_str(), path.c_str()) != 0)
        return false;
    all().paths.erase(_path);
    return true;
}

void Unfinished::removeAll() {
    all().mutex.lock();
    for (const std::string& path : all().paths)
        remove(path);
}

} // namespace osgTreeWind
