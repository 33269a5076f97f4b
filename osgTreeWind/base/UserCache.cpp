// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/UserCache.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>

namespace osgTreeWind {
namespace {

constexpr std::uint64_t maxBytes = 256'000'000; // bytes

/// Folder named by an environment variable. Empty if it is unset, or relative and so depends on the current
/// folder.
std::filesystem::path absoluteFolder(const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path folder = value ? value : "";
    return folder.is_absolute() ? folder : std::filesystem::path();
}

} // namespace

std::string userCacheFolder() {
    if (const char* wanted = std::getenv("OSGTREEWIND_FORM_CACHE"); wanted && *wanted)
        return std::string(wanted) == "off" ? std::string() : wanted;
    std::filesystem::path caches = absoluteFolder("XDG_CACHE_HOME");
    if (caches.empty() && !absoluteFolder("HOME").empty())
        caches = absoluteFolder("HOME") / ".cache";
    if (caches.empty())
        caches = absoluteFolder("LOCALAPPDATA");
    return caches.empty() ? std::string() : (caches / "osgtreewind").string();
}

DiskCache userCache() {
    return DiskCache(userCacheFolder(), maxBytes);
}

} // namespace osgTreeWind
