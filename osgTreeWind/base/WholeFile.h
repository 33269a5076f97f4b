// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// A file that is there when it is complete, and not before: it is written beside its place and brought there
/// in the end. What was there before stays until then.
class WholeFile {
public:
    /// @param path of a file, of a link to one, or of nothing yet.
    explicit WholeFile(const std::string& path);
    /// Takes away what was written, unless it was put in its place.
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Whether something else is there: a folder, a device.
    bool isTaken() const;
    /// Where to write until then.
    const std::string& unfinished() const { return _unfinished; }
    /// Once it is closed. False where it cannot be brought there.
    bool putInPlace();

private:
    std::string _path, _unfinished;
};

/// Writes a text as a whole file, or straight into what is there and no file. @return whether it is written.
bool writeWholeFile(const std::string& path, const std::string& text);

} // namespace osgTreeWind
