// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/WholeFile.h>

#include <cstdio>
#include <optional>
#include <string>

/// A table that is written row by row, into a file that is there when it is complete, or to standard output.
/// Ends the command where it cannot be written.
class WholeTable {
public:
    /// @param path "-" for standard output.
    explicit WholeTable(const std::string& path);
    ~WholeTable();
    WholeTable(const WholeTable&) = delete;
    WholeTable& operator=(const WholeTable&) = delete;

    std::FILE* file() const { return _file; }
    void finish();

private:
    std::optional<osgTreeWind::WholeFile> _whole; ///< None: standard output.
    std::FILE* _file = stdout;
};
