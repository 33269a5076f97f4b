// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TemporaryPath.h>

#include <osgTreeWind/system/File.h>
#include <osgTreeWind/system/Path.h>

#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

namespace osgTreeWind {
namespace {

struct Registry {
    std::mutex mutex;
    std::set<std::string> paths;
};

Registry& registry() {
    static Registry& instance = *new Registry; // never destroyed: threads may outlive main()
    return instance;
}

void remove(const std::string& path) {
    std::error_code ignored;
    std::filesystem::remove_all(toPath(path), ignored);
}

} // namespace

TemporaryPath::TemporaryPath(std::string path) : _path(std::move(path)) {
    const std::lock_guard lock(registry().mutex);
    registry().paths.insert(_path);
}

TemporaryPath::~TemporaryPath() {
    const std::lock_guard lock(registry().mutex);
    if (registry().paths.erase(_path) > 0)
        remove(_path);
}

void TemporaryPath::keep() {
    const std::lock_guard lock(registry().mutex);
    registry().paths.erase(_path);
}

bool TemporaryPath::moveTo(const std::string& path) {
    const std::lock_guard lock(registry().mutex);
    std::error_code problem;
    std::filesystem::rename(toPath(_path), toPath(path), problem);
    if (problem)
        return false;
    registry().paths.erase(_path);
    return true;
}

void TemporaryPath::removeAll() {
    registry().mutex.lock();
    for (const std::string& path : registry().paths)
        removeUnfinished(path);
}

} // namespace osgTreeWind
