// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace osgTreeWind {

template <typename Words = std::initializer_list<const char*>>
bool isOneOf(const std::string& word, const Words& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether a word begins with any of these.
inline bool startsWithAny(std::string_view word, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view one) { return word.substr(0, one.size()) == one; });
}

} // namespace osgTreeWind
