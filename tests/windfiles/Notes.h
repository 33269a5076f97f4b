// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/windfiles/WindContent.h>

#include <algorithm>
#include <string>

namespace osgTreeWind {

/// Whether a note contains this text.
inline bool hasNote(const WindSummary& summary, const std::string& part) {
    return std::any_of(summary.notes.begin(), summary.notes.end(),
                       [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

} // namespace osgTreeWind
