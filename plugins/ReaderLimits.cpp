// SPDX-License-Identifier: MIT
#include <plugins/ReaderLimits.h>

#include <osgTreeWind/base/MemoryLimit.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/ProcessLimits.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace osgTreeWind {

unsigned limitResources(const std::vector<std::string>& files, std::size_t memory, unsigned seconds) {
    std::uint64_t bytes = 0;
    for (const std::string& file : files) {
        std::error_code unknown;
        const auto found = std::filesystem::file_size(toPath(file), unknown);
        bytes += unknown ? 0 : found;
    }
    constexpr std::uint64_t least = std::uint64_t(1) << 28; // for the libraries
    limitMemory(std::max(least, std::min<std::uint64_t>(memory + 256 * bytes, memoryLimit())));
    const unsigned allowed = seconds + static_cast<unsigned>(bytes >> 20);
    limitTime(allowed);
    return allowed;
}

} // namespace osgTreeWind
