// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace osgTreeWind {

/// Name of the machine in its network; empty if unknown.
std::string hostName();
/// Name of the processor, and of the system with its version.
std::string processorName();
std::string systemName();
/// Number of processes that wanted to run, over the last minute; empty if unknown.
std::optional<double> machineLoad();
/// Bytes that this process has read from files and connections so far; 0 if unknown.
double bytesRead();

} // namespace osgTreeWind
