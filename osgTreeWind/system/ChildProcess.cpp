// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/ChildProcess.h>

#include <mutex>
#include <set>

namespace osgTreeWind {

namespace {

struct Running {
    std::mutex mutex;
    std::set<ChildProcess*> programs;
};

Running& running() {
    static Running& all = *new Running; // killAll() may be called after main()
    return all;
}

} // namespace

std::string ChildProcess::start(const std::string& program, const std::vector<std::string>& arguments,
                                Connection connection) {
    const std::lock_guard lock(running().mutex);
    std::string problem = startProgram(program, arguments, connection);
    if (problem.empty())
        running().programs.insert(this);
    return problem;
}

ChildProcess::End ChildProcess::finish() {
    if (_descriptor < 0)
        return {};
    awaitEnd();
    const std::lock_guard lock(running().mutex);
    running().programs.erase(this);
    return takeEnd();
}

void ChildProcess::killAll() {
    running().mutex.lock(); // never unlocked, so that no other program starts
    for (ChildProcess* program : running().programs)
        program->kill();
}

} // namespace osgTreeWind
