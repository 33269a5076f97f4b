// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace osgTreeWind {

/// Reads or writes some bytes of a connection to another process (ChildProcess), or of another open file.
/// Repeats calls that a signal interrupts. Writing raises no signal when the other process has ended.
/// @return the number of bytes; 0 at the end of the input; negative on an error.
std::ptrdiff_t readSome(int descriptor, void* bytes, std::size_t size);
std::ptrdiff_t writeSome(int descriptor, const void* bytes, std::size_t size);

/// Takes the standard output of this program for binary data, and sends what libraries print to standard
/// error.
/// @return the descriptor of the former standard output.
int takeStandardOutput();

/// Waits until the other process has read what was written, on systems where unread data is lost when this
/// process ends. @return whether it has.
bool finishOutput(int descriptor);

/// Whether a person types the standard input.
bool isInputTyped();
/// Whether a person sees the standard error.
bool isErrorSeen();

} // namespace osgTreeWind
