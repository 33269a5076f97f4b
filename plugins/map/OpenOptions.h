// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// What GDAL is to be told about a file of a format as it opens it.
class OpenOptions {
public:
    /// @param format GDAL's name of it.
    explicit OpenOptions(const std::string& format);
    OpenOptions(const OpenOptions&) = delete;
    OpenOptions& operator=(const OpenOptions&) = delete;
    ~OpenOptions();

    char** list() const { return _list; }

private:
    char** _list = nullptr;
    std::string _osmTags; ///< A file in memory; empty: none.
};

} // namespace osgTreeWind
