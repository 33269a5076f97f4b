// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Jobs.h>

#include <osgTreeWind/base/Guarded.h>

#include <atomic>
#include <exception>

namespace osgTreeWind {

void runJobs(const Executor& executor, std::size_t count, const std::function<void(std::size_t)>& job) {
    std::atomic<bool> failed{false};
    std::exception_ptr first;
    executor(count, [&](std::size_t i) {
        if (failed)
            return;
        runCatching([&] { job(i); },
                    [&] {
                        if (!failed.exchange(true))
                            first = std::current_exception();
                    });
    });
    if (first)
        std::rethrow_exception(first);
}

} // namespace osgTreeWind
