// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/DiskCache.h>

#include <string>

namespace osgTreeWind {

/// Folder of the user's cache: the environment variable OSGTREEWIND_FORM_CACHE, or `osgtreewind` in
/// `XDG_CACHE_HOME` or `~/.cache`, or in `LOCALAPPDATA` on Windows. Empty if the variable is `off` or there
/// is no such folder.
std::string userCacheFolder();

/// The cache in this folder, of at most 256 MB, for grown forms and painted pictures of all programs.
DiskCache userCache();

} // namespace osgTreeWind
