// SPDX-License-Identifier: MIT
#include <plugins/ReaderLimits.h>

#include <osgTreeWind/base/MemoryLimit.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {

unsigned limitResources(const std::vector<std::string>& files, std::size_t memory, unsigned seconds) {
    rlim_t bytes = 0;
    for (const std::string& file : files) {
        std::error_code unknown;
        const auto found = std::filesystem::file_size(file, unknown);
        bytes += unknown ? 0 : found;
    }
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages; // used by this program already
    constexpr rlim_t least = rlim_t(1) << 28;   // for the libraries
    const rlim_t wanted = std::max<rlim_t>(least, std::min<rlim_t>(memory + 256 * bytes, memoryLimit()));
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + wanted;
    const rlimit none{0, 0}, address{most, most};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_AS, &address);
    sigset_t all; // the parent process may have blocked SIGALRM
    sigfillset(&all);
    sigprocmask(SIG_UNBLOCK, &all, nullptr);
    signal(SIGALRM, SIG_DFL);
    const unsigned allowed = seconds + static_cast<unsigned>(bytes >> 20);
    alarm(allowed);
    return allowed;
}

} // namespace osgTreeWind
