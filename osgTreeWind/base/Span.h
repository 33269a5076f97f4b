// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Values that stand in a row and belong to someone else.
template <typename T>
struct Span {
    const T* data = nullptr;
    std::size_t size = 0;

    Span() = default;
    Span(const T* first, std::size_t count) : data(first), size(count) {}
    Span(const std::vector<T>& values) : data(values.data()), size(values.size()) {}

    const T& operator[](std::size_t i) const { return data[i]; }
    const T* begin() const { return data; }
    const T* end() const { return data + size; }
};

} // namespace osgTreeWind
