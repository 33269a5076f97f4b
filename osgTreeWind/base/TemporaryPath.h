// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// Removes a file or folder, with its contents, on destruction unless it was kept or moved.
class TemporaryPath {
public:
    /// @param path need not exist yet.
    explicit TemporaryPath(std::string path);
    ~TemporaryPath();
    TemporaryPath(const TemporaryPath&) = delete;
    TemporaryPath& operator=(const TemporaryPath&) = delete;

    const std::string& path() const { return _path; }
    /// The file or folder will not be removed.
    void keep();
    /// Renames the file or folder, replacing `path`, and keeps it. @return whether that succeeded.
    bool moveTo(const std::string& path);

    /// Removes the files and folders of all instances. Call it only before the process exits: afterwards, a
    /// thread that uses an instance blocks forever.
    static void removeAll();

private:
    std::string _path;
};

} // namespace osgTreeWind
