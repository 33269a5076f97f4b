// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/AtomicFile.h>

#include <cstdio>
#include <optional>
#include <string>

/// Table that is written row by row to standard output, or to a file that appears when it is complete. Throws
/// CommandError on a write error.
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
    std::optional<osgTreeWind::AtomicFile> _whole; ///< Empty for standard output.
    std::FILE* _file = stdout;
};
