// SPDX-License-Identifier: MIT
#pragma once

// libtomlplusplus throws parse errors; as headers alone it returns them.
#undef TOML_SHARED_LIB
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/impl/preprocessor.h>
// Malformed text ("[=]") fails assertions of toml++ 3.3, which it takes for granted when NDEBUG is set.
// Behind them it checks again and reports the error.
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(condition) static_assert(true)
#define TOML_ASSERT_ASSUME(condition) static_assert(true)
#include <toml++/toml.h>
