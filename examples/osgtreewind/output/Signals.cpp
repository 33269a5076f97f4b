// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/Signals.h>

#include <osgTreeWind/base/TemporaryPath.h>
#include <osgTreeWind/system/ChildProcess.h>
#include <osgTreeWind/system/Console.h>

#include <chrono>

namespace {

std::timed_mutex& rowMutex() {
    static std::timed_mutex& mutex =
        *new std::timed_mutex; // never destroyed: the thread of exitOnSignals() may outlive main()
    return mutex;
}

} // namespace

void exitOnSignals() {
    osgTreeWind::exitOnInterrupt([] {
        // Not forever: a row never ends if the program that reads it has stopped reading.
        (void)rowMutex().try_lock_for(std::chrono::seconds(2));
        osgTreeWind::ChildProcess::killAll();
        osgTreeWind::TemporaryPath::removeAll();
    });
}

WholeRow::WholeRow() : _lock(rowMutex()) {}
