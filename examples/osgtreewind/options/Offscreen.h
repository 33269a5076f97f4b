// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

// Options of all commands that draw without a display.

struct PictureSize {
    int width = 0, height = 0; ///< Pixels.
};

/// Parses "WIDTHxHEIGHT", each from 1 to `largest`. Throws CLI::ValidationError for the option --size.
PictureSize parsePictureSize(const std::string& text, int largest);

void addBackendOption(CLI::App& command, std::string& backend);
void addProfileOption(CLI::App& command, osgTreeWind::ContextProfile& profile);
/// Replaces this process by the program that is linked with the other backend, with the same arguments.
[[noreturn]] void runOtherBackend(const std::string& backend);
