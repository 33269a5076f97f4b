// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/TemporaryPath.h>

#include <string>

namespace osgTreeWind {

/// Writes a file atomically: into a temporary file in the same folder, which commit() renames to the target.
/// Until then an existing file stays unchanged. Special files such as pipes are written directly.
class AtomicFile {
public:
    /// Removes temporary files that killed processes left in the same folder.
    /// @param path of the target: a file, a link to one, or a path that does not exist yet.
    explicit AtomicFile(const std::string& path);

    /// Whether the target exists and is not a regular file, but for example a folder or a device.
    bool isSpecial() const { return _isSpecial; }
    /// Path of the file to write into until commit().
    const std::string& writePath() const { return _isSpecial ? _path : _temporary.path(); }
    /// Moves the temporary file to the target. Close it first. @return whether that succeeded.
    bool commit() { return _isSpecial || _temporary.moveTo(_path); }
    /// A problem that says why the file cannot be written. Call it while the temporary file exists.
    /// @param fallback reason if none can be determined.
    Diagnostic problem(const std::string& fallback = {}) const;

private:
    std::string _given, _path;
    bool _isSpecial;
    TemporaryPath _temporary;
};

/// Writes a file with AtomicFile. @return the problems; empty on success.
Diagnostics writeFileAtomically(const std::string& path, const std::string& bytes);

} // namespace osgTreeWind
