// SPDX-License-Identifier: MIT
#pragma once

/// Exports a symbol from the library, which hides all others (cmake/PublicHeaders.cmake).
#define OSGTREEWIND_EXPORT __attribute__((visibility("default")))
