// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace osgTreeWind {

/// Excludes other processes that lock the same folder, until it is destroyed or the process ends.
class FolderLock {
public:
    /// @param folder must exist.
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Why the folder cannot be opened; empty if it can be.
    const std::string& problem() const { return _problem; }
    /// Whether this lock excludes others: false if another process holds one.
    bool isHeld() const { return _isHeld; }

private:
    std::string _problem;
    std::intptr_t _handle = -1;
    bool _isHeld = false;
};

} // namespace osgTreeWind
