// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// What keeps a file that another file names from being opened; empty: nothing. Where the environment
/// variable OSGTREEWIND_TRUST is `folder`, it has to lie in one of these folders or below, once links are
/// resolved. docs/trust.md says more.
std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders);

/// The folders of an environment variable, parted as those of PATH.
std::vector<std::string> foldersOf(const char* variable);

} // namespace osgTreeWind
