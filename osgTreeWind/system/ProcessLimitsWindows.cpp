// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/ChildProcess.h>
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/ProcessLimits.h>
#include <osgTreeWind/system/Windows.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace osgTreeWind {

namespace {

/// Ends the process when its time is up.
class Timer {
public:
    Timer() {
        std::thread([this] {
            std::unique_lock lock(_mutex);
            for (;;) {
                if (_end == Clock::time_point::max())
                    _changed.wait(lock);
                else if (_changed.wait_until(lock, _end) == std::cv_status::timeout && Clock::now() >= _end)
                    TerminateProcess(GetCurrentProcess(), timeIsUpStatus);
            }
        }).detach();
    }
    void set(unsigned seconds) {
        const std::lock_guard lock(_mutex);
        _end = seconds > 0 ? Clock::now() + std::chrono::seconds(seconds) : Clock::time_point::max();
        _changed.notify_one();
    }

private:
    using Clock = std::chrono::steady_clock;

    std::mutex _mutex;
    std::condition_variable _changed;
    Clock::time_point _end = Clock::time_point::max();
};

} // namespace

void limitMemory(std::uint64_t bytes) {
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limit{};
    limit.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    limit.ProcessMemoryLimit = static_cast<SIZE_T>(addressSpace() + bytes);
    const HANDLE job = CreateJobObjectW(nullptr, nullptr); // open until the process ends
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limit, sizeof limit);
    AssignProcessToJobObject(job, GetCurrentProcess());
}

void limitTime(unsigned seconds) {
    static Timer& timer = *new Timer; // its thread never ends
    timer.set(seconds);
}

} // namespace osgTreeWind
