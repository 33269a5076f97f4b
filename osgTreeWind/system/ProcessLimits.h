// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// Lets allocations of this process beyond `bytes` more than it uses now fail with std::bad_alloc; a system
/// that cannot do so ends the process. From then on, a crash leaves no core file and opens no window.
void limitMemory(std::uint64_t bytes);
/// Ends this process after a time, whatever it does. @param seconds from now; 0: never. Replaces an earlier
/// limit.
void limitTime(unsigned seconds);

} // namespace osgTreeWind
