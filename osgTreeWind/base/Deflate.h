// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace osgTreeWind {

/// Compresses bytes with zlib, for speed.
std::string deflated(const std::string& plain);

/// Inverse of deflated(). Nullopt if the bytes are damaged, or if more than `maxSize` bytes would result.
std::optional<std::string> inflated(const std::string& bytes, std::size_t maxSize);

} // namespace osgTreeWind
