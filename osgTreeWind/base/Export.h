// SPDX-License-Identifier: MIT
#pragma once

/// Exports a symbol from the library, which hides all others (cmake/PublicHeaders.cmake). The package defines
/// OSGTREEWIND_STATIC for programs that link the library statically; the library defines OSGTREEWIND_BUILD.
#if defined(_WIN32) && defined(OSGTREEWIND_STATIC)
#define OSGTREEWIND_EXPORT
#elif defined(_WIN32) && defined(OSGTREEWIND_BUILD)
#define OSGTREEWIND_EXPORT __declspec(dllexport)
#elif defined(_WIN32)
#define OSGTREEWIND_EXPORT __declspec(dllimport)
#else
#define OSGTREEWIND_EXPORT __attribute__((visibility("default")))
#endif
