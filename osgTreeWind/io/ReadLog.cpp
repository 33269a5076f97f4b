// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ReadLog.h>

#include <utility>

namespace osgTreeWind {

void ReadLog::add(Diagnostic problem) {
    if (problems.size() >= mostProblems)
        return;
    if (problem.file.empty())
        problem.file = file;
    problems.push_back(std::move(problem));
}

} // namespace osgTreeWind
