// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// Bytes that this process can still allocate: the smaller of the machine's available memory and what a limit
/// of the process leaves, such as that of `ulimit -v`. The largest std::uint64_t if neither is known.
std::uint64_t availableMemory();
/// Bytes of address space that this process uses; 0 if unknown.
std::uint64_t addressSpace();
/// Bytes of this process in the machine's memory; 0 if unknown.
double residentBytes();
/// Bytes that this process has allocated and not freed; 0 if the allocator does not tell.
double allocatedBytes();
/// Keeps freed memory in the process, so that measured times contain no page faults of allocations.
void keepFreedMemory();

} // namespace osgTreeWind
