// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Values that stand in a row and belong to someone else.
template <typename T>
struct Span {
    const T* data = nullptr; ///< The first of them; null where there are none.
    std::size_t size = 0;    ///< How many there are.

    Span() = default;
    Span(const T* first, std::size_t count) : data(first), size(count) {} ///< Of an array.
    Span(const std::vector<T>& values)
        : data(values.data()), size(values.size()) {} ///< Of all values; as long as they stay where they are.

    const T& operator[](std::size_t i) const { return data[i]; } ///< Unchecked.
    const T* begin() const { return data; }                      ///< For loops.
    const T* end() const { return data + size; }                 ///< One past the last.
};

} // namespace osgTreeWind
