// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/Signals.h>

#include <examples/osgtreewind/pictures/VideoWriter.h>

#include <osgTreeWind/base/TemporaryPath.h>
#include <osgTreeWind/system/Console.h>

namespace {

std::mutex& rowMutex() {
    static std::mutex& mutex =
        *new std::mutex; // never destroyed: the thread of exitOnSignals() may outlive main()
    return mutex;
}

} // namespace

void exitOnSignals() {
    osgTreeWind::exitOnInterrupt([] {
        rowMutex().lock();
        VideoWriter::endAll();
        osgTreeWind::TemporaryPath::removeAll();
    });
}

WholeRow::WholeRow() : _lock(rowMutex()) {}
