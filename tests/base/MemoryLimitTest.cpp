// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>

#include <osgTreeWind/base/MemoryLimit.h>

#include <gtest/gtest.h>

#ifndef _WIN32
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <cstdint>
#include <fstream>

namespace osgTreeWind {
namespace {

// Sanitizers reserve terabytes of addresses, and Windows has no such limit.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(_WIN32)
TEST(MemoryLimit, RespectsTheAddressSpaceLimitOfTheProcess) {
    rlimit former{};
    getrlimit(RLIMIT_AS, &former);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit space = former;
    space.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (rlim_t(1) << 28);
    setrlimit(RLIMIT_AS, &space);
    const std::uint64_t limit = memoryLimit();
    setrlimit(RLIMIT_AS, &former);
    EXPECT_NEAR(static_cast<double>(limit), 0x1p28, 0x1p23);
}
#endif

TEST(MemoryLimit, ReadsTheEnvironmentVariable) {
    for (const auto& [text, bytes] : {std::pair<const char*, std::uint64_t>("12345", 12345),
                                      {"20k", 20000},
                                      {"1.5M", 1500000},
                                      {"3G", 3000000000},
                                      {"2T", 2000000000000},
                                      {"0", 0}}) {
        const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", text);
        EXPECT_EQ(memoryLimit(), bytes) << text;
    }
    for (const char* invalid : {"", "k", "much", "-1", "1e30T", "nan"}) {
        const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", invalid);
        EXPECT_GT(memoryLimit(), 1000000u) << "expected the machine's limit for " << invalid;
    }
}

} // namespace
} // namespace osgTreeWind
