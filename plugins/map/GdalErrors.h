// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// Hears what GDAL says on this thread while it lives, so that nothing is printed.
class GdalErrors {
public:
    GdalErrors();
    GdalErrors(const GdalErrors&) = delete;
    GdalErrors& operator=(const GdalErrors&) = delete;
    ~GdalErrors();

    /// The first error, on one line; empty: none.
    const std::string& text() const { return _error; }
    /// The same, or what to say where GDAL gave no reason.
    std::string textOr(const char* otherwise) const { return _error.empty() ? otherwise : _error; }
    /// The first few warnings.
    const std::vector<std::string>& warnings() const { return _warnings; }

private:
    static void hear(int severity, int number, const char* text);

    std::string _error;
    std::vector<std::string> _warnings;
};

/// Makes all of GDAL's formats known; needed before any file is opened.
void registerGdal();

} // namespace osgTreeWind
