// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MemoryLimit.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/Program.h>

#include <cmath>
#include <optional>

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
    std::string text = environmentVariable("OSGTREEWIND_MAX_MEMORY").value_or("");
    double unit = 1.0;
    const std::size_t suffix = std::string("kMGT").find(text.empty() ? ' ' : text.back());
    if (suffix != std::string::npos) {
        for (std::size_t i = 0; i <= suffix; ++i)
            unit *= 1000.0;
        text.pop_back();
    }
    const std::optional<double> number = parseNumber(text);
    if (!number || *number < 0.0 || *number * unit >= 0x1p64)
        return std::nullopt;
    return static_cast<std::uint64_t>(*number * unit);
}

} // namespace

std::uint64_t memoryLimit() {
    const std::optional<std::uint64_t> wanted = environmentLimit();
    return wanted ? *wanted : availableMemory();
}

std::string problemOfMemory(const std::string& what, std::uint64_t bytes) {
    const std::uint64_t limit = memoryLimit();
    if (bytes <= limit)
        return {};
    return what + " need about " + bytesText(bytes) + " of memory; the limit is " + bytesText(limit) +
           " (set another with OSGTREEWIND_MAX_MEMORY)";
}

} // namespace osgTreeWind
