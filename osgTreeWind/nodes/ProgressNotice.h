// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Notify>

#include <chrono>
#include <cstddef>
#include <mutex>

namespace osgTreeWind {

/// Callback that prints one OSG_NOTICE if growing a forest takes more than a second. Called for each tree.
class ProgressNotice {
public:
    explicit ProgressNotice(std::size_t trees) : _trees(trees) {}
    void operator()() {
        ++_done;
        if (_isPrinted || Clock::now() - _start < std::chrono::seconds(1))
            return;
        _isPrinted = true;
        static std::mutex mutex; // OSG's stream has no lock, and several threads may load forests
        const std::lock_guard<std::mutex> lock(mutex);
        OSG_NOTICE << "osgTreeWind: growing a forest, " << _done << " of " << _trees << " trees so far"
                   << std::endl;
    }

private:
    using Clock = std::chrono::steady_clock;
    std::size_t _trees, _done = 0;
    Clock::time_point _start = Clock::now();
    bool _isPrinted = false;
};

} // namespace osgTreeWind
