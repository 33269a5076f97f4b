// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace osgTreeWind {

/// What is learnt about one document while it is read.
struct ReadLog {
    static constexpr std::size_t mostProblems = 100;

    std::string file;                  ///< Name used in diagnostics.
    std::vector<std::string> settings; ///< ForestFileOptions::settings.
    Diagnostics problems;              ///< The first `mostProblems`, in the order found.
    std::set<std::string> keys;        ///< Every dotted key the reader knows of in the tables it has met.

    void add(Diagnostic problem); ///< `problem.file` is filled in when empty.
};

} // namespace osgTreeWind
