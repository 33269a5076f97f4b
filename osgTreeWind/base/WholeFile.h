// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/Unfinished.h>

#include <string>

namespace osgTreeWind {

/// A file that is there when it is complete, and not before: it is written beside its place and moved there
/// in the end. What was there before stays until then. What is no regular file, such as a pipe, is written
/// into.
class WholeFile {
public:
    /// Removes what programs that were killed have left in that folder.
    /// @param path of a file, of a link to one, or of nothing yet.
    explicit WholeFile(const std::string& path);

    /// Whether something else is there: a folder, a device.
    bool isTaken() const { return _isTaken; }
    /// Where to write until then.
    const std::string& unfinished() const { return _isTaken ? _path : _unfinished.path(); }
    /// Once it is closed. False where it cannot be moved there; then nothing is left of it.
    bool putInPlace() { return _isTaken || _unfinished.finishAs(_path); }
    /// That it cannot be written, and why, as far as that can be seen while the unfinished file is there.
    /// @param otherwise what to say where nothing can be seen.
    Diagnostic problem(const std::string& otherwise = {}) const;

private:
    std::string _given, _path;
    bool _isTaken;
    Unfinished _unfinished;
};

/// Writes bytes as a whole file. @return why it is not written; empty: it is.
Diagnostics writeWholeFile(const std::string& path, const std::string& bytes);

} // namespace osgTreeWind
