// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/Windows.h>

#include <algorithm>
#include <limits>

#include <psapi.h>

namespace osgTreeWind {

namespace {

PROCESS_MEMORY_COUNTERS_EX memoryCounters() {
    PROCESS_MEMORY_COUNTERS_EX memory{};
    K32GetProcessMemoryInfo(GetCurrentProcess(), reinterpret_cast<PROCESS_MEMORY_COUNTERS*>(&memory),
                            sizeof memory);
    return memory;
}

} // namespace

std::uint64_t availableMemory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    if (!GlobalMemoryStatusEx(&status))
        return std::numeric_limits<std::uint64_t>::max();
    // Windows promises no more memory than it has, so what may be committed is a limit, too.
    return std::min<std::uint64_t>({status.ullAvailPhys, status.ullAvailPageFile, status.ullAvailVirtual});
}

std::uint64_t addressSpace() {
    const PROCESS_MEMORY_COUNTERS_EX memory = memoryCounters();
    return std::max(memory.PrivateUsage, memory.WorkingSetSize); // Wine does not count the first
}

double residentBytes() {
    return static_cast<double>(memoryCounters().WorkingSetSize);
}

double allocatedBytes() {
    return 0.0;
}

void keepFreedMemory() {}

} // namespace osgTreeWind
