// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MemoryLimit.h>

#include <osgTreeWind/base/Number.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>

#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {
namespace {

/// The size with at most three significant digits, such as "1.5 GB".
std::string bytesText(std::uint64_t bytes) {
    const char* units[] = {" bytes", " kB", " MB", " GB", " TB"};
    auto number = static_cast<double>(bytes);
    int unit = 0;
    for (; number >= 999.5 && unit < 4; ++unit)
        number /= 1000.0;
    const double step = number < 9.995 ? 0.01 : number < 99.95 ? 0.1 : 1.0;
    return numberText(std::round(std::round(number / step) * step * 100.0) / 100.0) + units[unit];
}

std::optional<std::uint64_t> environmentLimit() {
    const char* value = std::getenv("OSGTREEWIND_MAX_MEMORY");
    std::string text = value ? value : "";
    double unit = 1.0;
    const std::size_t suffix = std::string("kMGT").find(text.empty() ? ' ' : text.back());
    if (suffix != std::string::npos) {
        unit = std::pow(1000.0, static_cast<double>(suffix + 1));
        text.pop_back();
    }
    const std::optional<double> number = parseNumber(text);
    if (!number || *number < 0.0 || *number * unit >= 0x1p64)
        return std::nullopt;
    return static_cast<std::uint64_t>(*number * unit);
}

} // namespace

std::uint64_t memoryLimit() {
    if (const auto limit = environmentLimit())
        return *limit;
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
    std::ifstream machine("/proc/meminfo");
    for (std::string key; machine >> key; machine.ignore(256, '\n'))
        if (std::uint64_t kilobytes = 0; key == "MemAvailable:" && machine >> kilobytes)
            limit = 1024 * kilobytes;
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) { // ulimit -v
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const std::uint64_t used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
        limit =
            std::min<std::uint64_t>(limit, space.rlim_cur - std::min<std::uint64_t>(used, space.rlim_cur));
    }
    return limit;
}

std::string problemOfMemory(const std::string& what, std::uint64_t bytes) {
    const std::uint64_t limit = memoryLimit();
    if (bytes <= limit)
        return {};
    return what + " need about " + bytesText(bytes) + " of memory; the limit is " + bytesText(limit) +
           " (set another with OSGTREEWIND_MAX_MEMORY)";
}

} // namespace osgTreeWind
