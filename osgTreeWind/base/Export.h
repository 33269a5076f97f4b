// SPDX-License-Identifier: MIT
#pragma once

/// Marks what the library exports; all else in it is hidden (cmake/PublicHeaders.cmake).
#define OSGTREEWIND_EXPORT __attribute__((visibility("default")))
