// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Room for `size` elements, and where there was not, for an eighth more instead of as many again: forests
/// are large.
template <typename T>
void makeRoomFor(std::vector<T>& elements, std::size_t size) {
    if (size > elements.capacity())
        elements.reserve(size + size / 8);
}

} // namespace osgTreeWind
