// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/InputFile.h>

#include <string>

namespace osgTreeWind {

/// A file whose beginning tells the reader of the rest. Not part of the interface.
class WindInput {
public:
    /// Reads the first kilobyte.
    explicit WindInput(const std::string& path);

    const std::string& path() const { return _path; }
    /// The first kilobyte; less of a short file. A file that is empty or cannot be read is a problem.
    Result<std::string> head() const;
    /// All of it, after head() was good.
    Result<std::string> bytes();

private:
    std::string _path, _head;
    Result<std::ifstream> _file;
};

} // namespace osgTreeWind
