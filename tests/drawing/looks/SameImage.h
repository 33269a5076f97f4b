// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <cstring>

namespace osgTreeWind {

/// Whether two images have the same size, mipmap levels and bytes.
inline bool isSameImage(const osg::Image& a, const osg::Image& b) {
    const unsigned size = a.getTotalSizeInBytesIncludingMipmaps();
    return a.s() == b.s() && a.t() == b.t() && a.getMipmapLevels() == b.getMipmapLevels() &&
           size == b.getTotalSizeInBytesIncludingMipmaps() && std::memcmp(a.data(), b.data(), size) == 0;
}

} // namespace osgTreeWind
