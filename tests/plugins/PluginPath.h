// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>

#include <osgDB/Registry>

#include <string>

/// Makes OSG find the plugins of this build, as OSG_LIBRARY_PATH=build/lib does.
inline void usePluginsOfThisBuild() {
    osgDB::FilePathList& folders = osgDB::Registry::instance()->getLibraryFilePathList();
    if (folders.empty() || folders.front() != OSGTREEWIND_PLUGIN_PATH)
        folders.push_front(OSGTREEWIND_PLUGIN_PATH);
}

inline std::string exampleFile(const std::string& name) {
    return OSGTREEWIND_SOURCE_DIR "/examples/" + name;
}
