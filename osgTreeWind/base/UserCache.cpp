// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/UserCache.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <cstdint>
#include <filesystem>

namespace osgTreeWind {
namespace {

constexpr std::uint64_t maxBytes = 256'000'000; // bytes

} // namespace

std::string userCacheFolder() {
    if (const std::string wanted = environmentVariable("OSGTREEWIND_FORM_CACHE").value_or("");
        !wanted.empty())
        return wanted == "off" ? std::string() : wanted;
    const std::filesystem::path caches = cacheFolder();
    return caches.is_absolute() ? toText(caches / "osgtreewind") : std::string(); // not in the current folder
}

DiskCache userCache() {
    return DiskCache(userCacheFolder(), maxBytes);
}

} // namespace osgTreeWind
