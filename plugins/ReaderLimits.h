// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Limits the memory and the time of this process to what intact files need, and disables core files, as
/// damaged files may crash or occupy it.
/// @param files to be read. @param memory bytes, in addition to 256 bytes per byte of the files; the sum is
/// limited to memoryLimit(), and at least 256 MiB.
/// @param seconds in addition to one second per MiB of the files.
/// @return the limit of time in seconds.
unsigned limitResources(const std::vector<std::string>& files, std::size_t memory, unsigned seconds);

} // namespace osgTreeWind
