// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace osgTreeWind {

// Paintings in the user's cache (base/UserCache.h). Any thread.

/// A painting as bytes.
class PaintedBytes {
public:
    /// @param work name of what is painted, and all that it is painted from. Sources are part of the key.
    explicit PaintedBytes(const std::string& work);

    /// Nullopt if they are not in the cache or damaged.
    std::optional<std::string> find() const;
    void store(const std::string& bytes) const;

private:
    std::string _key;
};

/// An RGBA8 image from the cache; if absent, painted and stored. Its name is `work`. Null if `paint` returns
/// null.
/// @param work see PaintedBytes.
osg::ref_ptr<osg::Image> cachedImage(const std::string& work,
                                     const std::function<osg::ref_ptr<osg::Image>()>& paint);

/// Appends an RGBA8 image with its mipmap levels, losslessly compressed.
void appendImage(const osg::Image& image, std::string& bytes);
/// Reads what appendImage() wrote at a place, and moves the place behind it. Null if the bytes are not an
/// image.
osg::ref_ptr<osg::Image> takeImage(const std::string& bytes, std::size_t& place);

/// A digest of the content of a file; 16 bytes. Empty if it cannot be read.
std::string digestOfFile(const std::string& path);

} // namespace osgTreeWind
