// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/scanfiles/ScanFile.h>

#include <optional>

/// The way of trees, or of what is wrong with them, from a process that reads them to the one that wants
/// them; both of the same build. Not part of the interface.
namespace osgTreeWind::ScanWire {

/// Writes to a file descriptor. False when nobody takes it any more.
bool send(int descriptor, Result<ScanFile>& scan);
/// Reads what send() wrote: nothing where it ends too early or makes no sense.
std::optional<Result<ScanFile>> receive(int descriptor);

} // namespace osgTreeWind::ScanWire
