// SPDX-License-Identifier: MIT
#pragma once

#include <osgDB/Registry>

#include <string>

/// Prepends a folder to OSG_FILE_PATH during its lifetime.
class FilePath {
public:
    explicit FilePath(const std::string& folder)
        : _former(osgDB::Registry::instance()->getDataFilePathList()) {
        osgDB::Registry::instance()->getDataFilePathList().push_front(folder);
    }
    ~FilePath() { osgDB::Registry::instance()->getDataFilePathList() = _former; }

private:
    osgDB::FilePathList _former;
};
