// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Reserves capacity for `size` elements. If the vector must grow, it grows to 9/8 of `size` instead of
/// doubling, to save memory in large forests.
template <typename T>
void reserveGrowth(std::vector<T>& elements, std::size_t size) {
    if (size > elements.capacity())
        elements.reserve(size + size / 8);
}

} // namespace osgTreeWind
