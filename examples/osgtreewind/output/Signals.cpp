// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/Signals.h>

#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/Unfinished.h>

#include <csignal>
#include <thread>

#include <unistd.h>

namespace {

std::mutex& rowMutex() {
    static std::mutex& mutex = *new std::mutex; // the thread may outlive main()
    return mutex;
}

} // namespace

void endOnSignals() {
    sigset_t ends;
    sigemptyset(&ends);
    sigaddset(&ends, SIGINT);
    sigaddset(&ends, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ends, nullptr); // in all threads to come
    std::thread([ends] {
        int signal = 0;
        while (sigwait(&ends, &signal) != 0)
            ;
        rowMutex().lock();
        VideoWriter::endAll();
        osgTreeWind::Unfinished::removeAll();
        _exit(128 + signal);
    }).detach();
}

WholeRow::WholeRow() : _lock(rowMutex()) {}
