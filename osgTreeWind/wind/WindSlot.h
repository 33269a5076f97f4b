// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>

#include <memory>
#include <mutex>
#include <utility>

namespace osgTreeWind {

/// Holds the wind that the host has set last. Any thread may set and get it at any time.
class WindSlot {
public:
    explicit WindSlot(Wind given = {}) : _wind(std::make_shared<const Wind>(std::move(given))) {}

    /// Replaces the wind. @return what check() finds; then nothing has changed.
    Diagnostics set(Wind given) {
        if (Diagnostics problems = check(given); !problems.empty())
            return problems;
        auto next = std::make_shared<const Wind>(std::move(given));
        const std::lock_guard<std::mutex> lock(_mutex);
        std::swap(_wind, next); // the old wind is destroyed after the lock is released
        return {};
    }
    std::shared_ptr<const Wind> get() const { ///< Never null.
        const std::lock_guard<std::mutex> lock(_mutex);
        return _wind;
    }

private:
    mutable std::mutex _mutex; // guards _wind
    std::shared_ptr<const Wind> _wind;
};

} // namespace osgTreeWind
