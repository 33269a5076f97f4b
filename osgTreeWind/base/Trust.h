// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// Why a file named by another file may not be opened; empty if it may. If the environment variable
/// OSGTREEWIND_TRUST is `folder`, the file must be in or below one of `folders`, after resolving links
/// (docs/trust.md).
std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders);

} // namespace osgTreeWind
