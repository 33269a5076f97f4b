// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/Signals.h>

#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/TemporaryPath.h>

#include <csignal>
#include <thread>

#include <unistd.h>

namespace {

std::mutex& rowMutex() {
    static std::mutex& mutex = *new std::mutex; // never destroyed: the signal thread may outlive main()
    return mutex;
}

} // namespace

void exitOnSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr); // inherited by all later threads
    std::thread([signals] {
        int signal = 0;
        while (sigwait(&signals, &signal) != 0)
            ;
        rowMutex().lock();
        VideoWriter::endAll();
        osgTreeWind::TemporaryPath::removeAll();
        _exit(128 + signal);
    }).detach();
}

WholeRow::WholeRow() : _lock(rowMutex()) {}
