// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <optional>

/// The way of a grid, or of what is wrong with it, from a process that reads it to the one that wants it;
/// both of the same build. Not part of the interface.
namespace osgTreeWind::WindWire {

/// Writes to a file descriptor. False when nobody takes it any more.
bool send(int descriptor, Result<WindContent>& content);
/// Reads what send() wrote: nothing where it ends too early or makes no sense.
std::optional<Result<WindContent>> receive(int descriptor);

} // namespace osgTreeWind::WindWire
