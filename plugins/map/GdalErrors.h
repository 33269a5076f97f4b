// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// Collects the messages of GDAL in this thread during its lifetime, in place of printing them.
class GdalErrors {
public:
    GdalErrors();
    GdalErrors(const GdalErrors&) = delete;
    GdalErrors& operator=(const GdalErrors&) = delete;
    ~GdalErrors();

    /// The first error as one line; may be empty.
    const std::string& text() const { return _error; }
    /// text(), or another text if it is empty.
    std::string textOr(const char* otherwise) const { return _error.empty() ? otherwise : _error; }
    /// The first few warnings.
    const std::vector<std::string>& warnings() const { return _warnings; }

private:
    static void handleError(int severity, int number, const char* text);

    std::string _error;
    std::vector<std::string> _warnings;
};

/// Registers all formats of GDAL. Call it before a file is opened.
void registerGdal();

} // namespace osgTreeWind
