// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Guarded.h>

#include <osg/Notify>

#include <atomic>

namespace osgTreeWind {

/// Keeps exceptions from OSG in the entries of an object, and says the first one. Any thread.
class EntryGuard {
public:
    /// Runs an entry. @param outcome what comes of it if it throws, for an OSG_WARN. @return whether it ran
    /// to its end.
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
