// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Command.h>

// What the commands that draw without a display share.

/// In pixels.
struct PictureSize {
    int width = 0, height = 0;
};

/// Reads "WIDTHxHEIGHT", sides from 1 to `largest`. Throws CLI::ValidationError for option --size.
PictureSize parsePictureSize(const std::string& text, int largest);

void addBackendOption(CLI::App& command, std::string& backend);
/// Runs this command in the program that is linked with the other backend.
[[noreturn]] void runOtherBackend(const std::string& backend);
