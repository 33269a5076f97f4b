// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// Problems, notes and known keys collected while a document is read.
struct ReadLog {
    static constexpr std::size_t maxProblems = 100;

    std::string file;                  ///< Name used in diagnostics.
    std::vector<std::string> settings; ///< ForestFileOptions::settings.
    std::vector<std::string> notes;    ///< For ForestFile::notes.
    Diagnostics problems;              ///< The first `maxProblems`, in the order found.
    std::set<std::string> keys;        ///< All dotted keys that are known in the tables read.

    /// Adds a problem; an empty `problem.file` is replaced by `file`.
    void add(Diagnostic problem) {
        if (problems.size() >= maxProblems)
            return;
        if (problem.file.empty())
            problem.file = file;
        problems.push_back(std::move(problem));
    }
};

} // namespace osgTreeWind
