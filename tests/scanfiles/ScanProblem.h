// SPDX-License-Identifier: MIT
#pragma once

#include <tests/base/FirstProblem.h>

#include <osgTreeWind/scanfiles/ScanFormats.h>

/// What is wrong with a scan of that text.
inline std::string problemOfText(const std::string& text) {
    return firstProblem(osgTreeWind::readScan(text, "a"));
}
