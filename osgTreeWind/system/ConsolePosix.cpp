// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Console.h>

#include <csignal>
#include <thread>

#include <unistd.h>

namespace osgTreeWind {

void exitOnInterrupt(void (*cleanUp)()) {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        sigaction(each, nullptr, &action);
        if (action.sa_handler != SIG_IGN) // as that of a program started by `nohup`, or by `&` in a script
            sigaddset(&signals, each);
    }
    pthread_sigmask(SIG_BLOCK, &signals, nullptr); // inherited by all later threads
    std::thread([signals, cleanUp] {
        int signal = 0;
        while (sigwait(&signals, &signal) != 0)
            ;
        cleanUp();
        _exit(128 + signal);
    }).detach();
}

void useUtf8Console() {}

} // namespace osgTreeWind
