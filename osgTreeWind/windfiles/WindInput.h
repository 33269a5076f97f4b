// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/InputFile.h>

#include <string>

namespace osgTreeWind {

/// An input file whose first kilobyte selects the reader.
class WindInput {
public:
    /// Reads the first kilobyte.
    explicit WindInput(const std::string& path);

    const std::string& path() const { return _path; }
    /// The first kilobyte, or less of a short file; a problem if the file is empty or cannot be read.
    Result<std::string> head() const;
    /// The whole file. Requires that head() succeeded.
    Result<std::string> bytes();

private:
    std::string _path, _head;
    Result<std::ifstream> _file;
};

} // namespace osgTreeWind
