// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Makes an interrupted program call `cleanUp` in a thread of its own and exit: with status 130 after Ctrl+C,
/// Ctrl+Break and a closed console, and 143 after SIGTERM. Call it before other threads start.
void exitOnInterrupt(void (*cleanUp)());

/// Prepares standard output and error for UTF-8 text with the same bytes on all systems.
void useUtf8Console();

} // namespace osgTreeWind
