// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace osgTreeWind {

/// The most bytes of memory that may be taken at once: the environment's OSGTREEWIND_MAX_MEMORY, bytes or a
/// number with k, M, G or T, else what the machine has available now and the process may have (ulimit -v).
/// The largest number where neither is known.
std::uint64_t memoryLimit();

/// How much memory `what` need and what the limit is; empty where they fit. @param what several of them.
std::string problemOfMemory(const std::string& what, std::uint64_t bytes);

} // namespace osgTreeWind
