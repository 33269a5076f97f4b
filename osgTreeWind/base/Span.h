// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Non-owning, read-only view of a contiguous array.
template <typename T>
struct Span {
    const T* data = nullptr; ///< First element; may be null if empty.
    std::size_t size = 0;    ///< Number of elements.

    Span() = default;                                                     ///< Empty.
    Span(const T* first, std::size_t count) : data(first), size(count) {} ///< View of an array.
    /// View of a whole vector; valid until the vector reallocates.
    Span(const std::vector<T>& values) : data(values.data()), size(values.size()) {}

    const T& operator[](std::size_t i) const { return data[i]; } ///< Not bounds-checked.
    const T* begin() const { return data; }                      ///< First element.
    const T* end() const { return data + size; }                 ///< One past the last element.
};

} // namespace osgTreeWind
