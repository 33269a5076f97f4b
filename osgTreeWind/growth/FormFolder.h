// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace osgTreeWind {

/// Bytes by keys in a folder of files, of which the ones used last are kept. Many threads and programs may
/// use one folder at once. Nothing here fails: what cannot be read is not there, what cannot be written is
/// not kept.
class FormFolder {
public:
    /// @param path made when something is kept; empty: nothing is. @param mostBytes of all its files
    /// together.
    FormFolder(std::string path, std::uint64_t mostBytes) : _path(std::move(path)), _mostBytes(mostBytes) {}

    /// What was kept by this key; none where it is not there, or was damaged.
    std::optional<std::string> find(const std::string& key) const;
    /// Takes away the files used longest ago where there are too many bytes.
    void keep(const std::string& key, const std::string& bytes) const;

    const std::string& path() const { return _path; }

private:
    std::string fileOf(const std::string& key) const;
    void trim() const;

    std::string _path;
    std::uint64_t _mostBytes;
};

} // namespace osgTreeWind
