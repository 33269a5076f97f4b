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
    sigset_t all; // the parent process may have blocked SIGALRM
    sigfillset(&all);
    sigprocmask(SIG_UNBLOCK, &all, nullptr);
    signal(SIGALRM, SIG_DFL);
    alarm(seconds);
}

} // namespace osgTreeWind
