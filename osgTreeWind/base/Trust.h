// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// Why a file may not give this name to another file, judged without opening anything; empty if it may.
/// Windows has names that are no files, and under OSGTREEWIND_TRUST=folder names another machine only if it
/// has one of `folders`.
std::string problemOfNaming(const std::string& name, const std::vector<std::string>& folders);

/// Why a file named by another file may not be opened; empty if it may. If the environment variable
/// OSGTREEWIND_TRUST is `folder`, the file must be in or below one of `folders`, after resolving links
/// (docs/trust.md).
std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders);

} // namespace osgTreeWind
