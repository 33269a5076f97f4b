// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// What is learnt about one document while it is read.
struct ReadLog {
    static constexpr std::size_t mostProblems = 100;

    std::string file;                  ///< Name used in diagnostics.
    std::vector<std::string> settings; ///< ForestFileOptions::settings.
    Diagnostics problems;              ///< The first `mostProblems`, in the order found.
    std::set<std::string> keys;        ///< Every dotted key the reader knows of in the tables it has met.

    /// `problem.file` is filled in when empty.
    void add(Diagnostic problem) {
        if (problems.size() >= mostProblems)
            return;
        if (problem.file.empty())
            problem.file = file;
        problems.push_back(std::move(problem));
    }
};

} // namespace osgTreeWind
