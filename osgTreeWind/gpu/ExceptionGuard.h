// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Guarded.h>

#include <osg/Notify>

#include <atomic>

namespace osgTreeWind {

/// Catches the exceptions in functions that OSG calls, and reports the first one with OSG_WARN. Any thread.
class ExceptionGuard {
public:
    /// Runs a function. @param outcome consequence of an exception, for the warning.
    /// @return false if the function threw.
    template <typename Entry>
    bool run(const char* outcome, const Entry& entry) const {
        const std::string problem = runGuarded(entry);
        if (!problem.empty() && !_warned.exchange(true))
            warn(problem, outcome);
        return problem.empty();
    }

private:
    static void warn(const std::string& problem, const char* outcome) {
        runGuarded([&] { OSG_WARN << "osgTreeWind: " << problem << "; " << outcome << std::endl; });
    }

    mutable std::atomic<bool> _warned{false};
};

} // namespace osgTreeWind
