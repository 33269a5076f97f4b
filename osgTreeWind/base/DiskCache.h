// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace osgTreeWind {

/// Key-value cache in a folder of files, which evicts the least recently used ones. Threads and programs may
/// use one folder at the same time. It reports no errors: an unreadable entry counts as absent, and an entry
/// that cannot be written is dropped.
class DiskCache {
public:
    /// @param path created when the first entry is stored; empty disables the cache.
    /// @param maxBytes limit of the total file size.
    DiskCache(std::string path, std::uint64_t maxBytes) : _path(std::move(path)), _maxBytes(maxBytes) {}

    /// Value of a key; nullopt if it is absent or damaged.
    std::optional<std::string> find(const std::string& key) const;
    /// Stores a value, then evicts the least recently used files if there are too many bytes.
    void store(const std::string& key, const std::string& bytes) const;

private:
    std::string filePath(const std::string& key) const;
    void evictOldestBut(const std::string& kept) const;

    std::string _path;
    std::uint64_t _maxBytes;
};

} // namespace osgTreeWind
