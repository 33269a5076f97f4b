// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/ProcessLimits.h>
#include <osgTreeWind/system/Windows.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

namespace osgTreeWind {

namespace {

/// Ends the process when its time is up, or when it uses too much memory, because Wine has no jobs with
/// limits.
class Watch {
public:
    Watch() {
        std::thread([this] {
            for (;;) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                if (Clock::now() >= _end.load())
                    TerminateProcess(GetCurrentProcess(), timeIsUpStatus);
                if (addressSpace() > _mostMemory)
                    TerminateProcess(GetCurrentProcess(), memoryIsUpStatus);
            }
        }).detach();
    }
    void setTime(unsigned seconds) {
        _end = seconds > 0 ? Clock::now() + std::chrono::seconds(seconds) : Clock::time_point::max();
    }
    void setMemory(std::uint64_t bytes) { _mostMemory = bytes; }

private:
    using Clock = std::chrono::steady_clock;

    std::atomic<Clock::time_point> _end{Clock::time_point::max()};
    std::atomic<std::uint64_t> _mostMemory{std::numeric_limits<std::uint64_t>::max()};
};

Watch& watch() {
    static Watch& watch = *new Watch; // its thread never ends
    return watch;
}

} // namespace

void limitMemory(std::uint64_t bytes) {
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limit{};
    limit.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    const std::uint64_t most = addressSpace() + bytes;
    limit.ProcessMemoryLimit = static_cast<SIZE_T>(most);
    const HANDLE job = CreateJobObjectW(nullptr, nullptr); // open until the process ends
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limit, sizeof limit);
    AssignProcessToJobObject(job, GetCurrentProcess());
    watch().setMemory(most);
}

void limitTime(unsigned seconds) {
    watch().setTime(seconds);
}

} // namespace osgTreeWind
