// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Notify>

#include <chrono>
#include <cstddef>
#include <mutex>

namespace osgTreeWind {

/// Says once what is going on when it has taken a second.
class Patience {
public:
    explicit Patience(std::size_t trees) : _trees(trees) {}
    void operator()() {
        ++_done;
        if (_said || Clock::now() - _start < std::chrono::seconds(1))
            return;
        _said = true;
        static std::mutex speaking; // OSG's stream has no lock, and several threads may load
        const std::lock_guard<std::mutex> lock(speaking);
        OSG_NOTICE << "osgTreeWind: growing a forest, " << _done << " of " << _trees << " trees so far"
                   << std::endl;
    }

private:
    using Clock = std::chrono::steady_clock;
    std::size_t _trees, _done = 0;
    Clock::time_point _start = Clock::now();
    bool _said = false;
};

} // namespace osgTreeWind
