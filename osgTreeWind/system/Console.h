// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Makes an interrupted program call `cleanUp` in a thread of its own and exit. On Linux the status is 130
/// after Ctrl+C, 129 when the terminal closes, and 143 after SIGTERM; signals that the program was told to
/// ignore stay ignored. On Windows, it is 130 after Ctrl+C, Ctrl+Break and a closed console, and `cleanUp`
/// has 4 s. Call it before other threads start.
void exitOnInterrupt(void (*cleanUp)());

/// Prepares standard output and error for UTF-8 text with the same bytes on all systems.
void useUtf8Console();

} // namespace osgTreeWind
