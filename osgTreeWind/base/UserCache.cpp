// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/UserCache.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <cstdint>
#include <filesystem>

namespace osgTreeWind {
namespace {

constexpr std::uint64_t maxBytes = 256'000'000; // bytes

/// Folder named by an environment variable. Empty if it is unset, or relative and so depends on the current
/// folder.
std::filesystem::path absoluteFolder(const char* variable) {
    const std::filesystem::path folder = toPath(environmentVariable(variable).value_or(""));
    return folder.is_absolute() ? folder : std::filesystem::path();
}

} // namespace

std::string userCacheFolder() {
    if (const std::string wanted = environmentVariable("OSGTREEWIND_FORM_CACHE").value_or("");
        !wanted.empty())
        return wanted == "off" ? std::string() : wanted;
    std::filesystem::path caches = absoluteFolder("XDG_CACHE_HOME");
    if (caches.empty() && !absoluteFolder("HOME").empty())
        caches = absoluteFolder("HOME") / ".cache";
    if (caches.empty())
        caches = absoluteFolder("LOCALAPPDATA");
    return caches.empty() ? std::string() : toText(caches / "osgtreewind");
}

DiskCache userCache() {
    return DiskCache(userCacheFolder(), maxBytes);
}

} // namespace osgTreeWind
