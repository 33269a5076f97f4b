// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/TableReader.h>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Folders in which OpenSceneGraph searches for files, from the environment variable OSG_FILE_PATH.
std::vector<std::string> hostFolders();

/// The folders in which the files of a document are searched.
class InputFolders {
public:
    /// @param document folder of the document.
    explicit InputFolders(std::string document = {}) : _folders{std::move(document)} {}

    /// The next folder to search.
    void add(std::string folder) { _folders.push_back(std::move(folder)); }
    const std::string& ofDocument() const { return _folders.front(); }
    /// Why a document may not name a file or folder so, judged without opening anything; empty if it may.
    std::string problemOfName(const std::string& name) const;
    /// Why OSGTREEWIND_TRUST=folder does not trust a path, which must be in the folders of the document, its
    /// host or OSG; otherwise empty.
    std::string problemOfTrust(const std::string& path) const;

    struct File {
        std::string path;
        std::ifstream stream;
    };
    /// Opens the file named by `key`; reports a problem if that fails.
    std::optional<File> open(TableReader& table, const std::string& key) const;
    /// Opens the file `name`, one of several named by `key`.
    std::optional<File> open(TableReader& table, const std::string& key, const std::string& name) const;

private:
    /// The folders of the document, its host and OSG.
    std::vector<std::string> trusted() const;

    std::vector<std::string> _folders; ///< In the order of the search.
};

} // namespace osgTreeWind
