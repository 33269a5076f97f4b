// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/AtomicFile.h>

#include <cstdio>
#include <optional>
#include <string>

/// Table that is written row by row to standard output, or to a file that appears when it is complete. Throws
/// CommandError on a write error.
class AtomicTable {
public:
    /// @param path "-" for standard output.
    explicit AtomicTable(const std::string& path);
    ~AtomicTable();
    AtomicTable(const AtomicTable&) = delete;
    AtomicTable& operator=(const AtomicTable&) = delete;

    std::FILE* file() const { return _file; }
    void finish();

private:
    std::optional<osgTreeWind::AtomicFile> _whole; ///< Empty for standard output.
    std::FILE* _file = stdout;
};
