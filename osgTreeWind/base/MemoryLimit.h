// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace osgTreeWind {

/// The largest amount of memory, in bytes, that may be allocated at once: the environment variable
/// OSGTREEWIND_MAX_MEMORY (bytes, or a number with k, M, G or T), or else the smaller of the machine's
/// available memory and what `ulimit -v` leaves the process. The largest std::uint64_t if neither is known.
std::uint64_t memoryLimit();

/// A message that states the memory needed and the limit; empty if `bytes` is within memoryLimit().
/// @param what a plural noun, the subject of the message, such as "its bytes".
std::string problemOfMemory(const std::string& what, std::uint64_t bytes);

} // namespace osgTreeWind
