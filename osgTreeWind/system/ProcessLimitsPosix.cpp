// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/ProcessLimits.h>

#include <csignal>

#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {

void limitMemory(std::uint64_t bytes) {
    const rlim_t most = addressSpace() + bytes;
    const rlimit none{0, 0}, address{most, most};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_AS, &address);
}

void limitTime(unsigned seconds) {
    [[maybe_unused]] static const bool isUnblocked = [] { // the parent process may have blocked SIGALRM
        sigset_t all;
        sigfillset(&all);
        signal(SIGALRM, SIG_DFL);
        return sigprocmask(SIG_UNBLOCK, &all, nullptr) == 0;
    }();
    alarm(seconds);
}

} // namespace osgTreeWind
