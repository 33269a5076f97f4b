// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Result.h>

#include <osgTreeWind/base/BadAccess.h>
#include <osgTreeWind/base/Unicode.h>

#include <cstdlib>
#include <iostream>

namespace osgTreeWind {

std::string Diagnostic::text() const {
    std::string place = file;
    if (line > 0) {
        place += ':' + std::to_string(line);
        if (column > 0)
            place += ':' + std::to_string(column);
    }
    std::string result;
    if (!place.empty())
        result += place + ": ";
    if (!key.empty())
        result += key + ": ";
    return asUtf8(result + message);
}

std::string toString(const Diagnostics& problems) {
    std::string lines;
    for (const Diagnostic& problem : problems)
        lines += (lines.empty() ? "" : "\n") + problem.text();
    return lines;
}

namespace {

bool stopsProgram = false;

} // namespace

void stopAtBadAccess(bool stops) {
    stopsProgram = stops;
}

void logBadAccess(const Diagnostics& problems) {
    std::cerr << "osgTreeWind: value() of a failed Result: " + problems.front().text() + '\n';
    if (stopsProgram)
        std::abort();
}

} // namespace osgTreeWind
