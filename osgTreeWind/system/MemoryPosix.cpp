// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

struct PageCounts {
    std::uint64_t all = 0, resident = 0;
};

PageCounts readPageCounts() {
    PageCounts pages;
    std::ifstream("/proc/self/statm") >> pages.all >> pages.resident;
    return pages;
}

std::uint64_t pageSize() {
    return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

} // namespace

std::uint64_t availableMemory() {
    std::uint64_t available = std::numeric_limits<std::uint64_t>::max();
    std::ifstream machine("/proc/meminfo");
    for (std::string key; machine >> key; machine.ignore(256, '\n'))
        if (std::uint64_t kilobytes = 0; key == "MemAvailable:" && machine >> kilobytes)
            available = 1024 * kilobytes;
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) // ulimit -v
        available = std::min<std::uint64_t>(
            available, space.rlim_cur - std::min<std::uint64_t>(addressSpace(), space.rlim_cur));
    return available;
}

std::uint64_t addressSpace() {
    return readPageCounts().all * pageSize();
}

double residentBytes() {
    return static_cast<double>(readPageCounts().resident * pageSize());
}

double allocatedBytes() {
#ifdef __GLIBC__
    const struct mallinfo2 memory = mallinfo2();
    return static_cast<double>(memory.uordblks + memory.hblkhd);
#else
    return 0.0;
#endif
}

void keepFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

} // namespace osgTreeWind
