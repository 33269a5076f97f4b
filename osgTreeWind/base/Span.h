// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace osgTreeWind {

/// Values that stand in a row and belong to someone else.
template <typename T>
struct Span {
    const T* data = nullptr;
    std::size_t size = 0;

    const T& operator[](std::size_t i) const { return data[i]; }
    const T* begin() const { return data; }
    const T* end() const { return data + size; }
};

} // namespace osgTreeWind
