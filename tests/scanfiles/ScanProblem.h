// SPDX-License-Identifier: MIT
#pragma once

#include <tests/base/FirstProblem.h>

#include <osgTreeWind/scanfiles/ScanFormats.h>

/// First problem of a text that is read as a scan.
inline std::string problemOfScanText(const std::string& text) {
    return firstProblem(osgTreeWind::readScan(text, "a"));
}
