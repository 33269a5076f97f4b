// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/PictureCache.h>

#include <osgTreeWind/base/Deflate.h>
#include <osgTreeWind/base/Digest.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/SourceHashes.h>
#include <osgTreeWind/base/UserCache.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace osgTreeWind {
namespace {

constexpr std::size_t maxImageBytes = std::size_t(1) << 24;

/// Precedes the texels of an image.
struct ImageHeader {
    std::int32_t width = 0, height = 0;
    std::uint32_t mipmaps = 0; ///< Levels below the first.
};

/// Number of bytes of an RGBA8 image with the first `mipmaps` levels of its mipmaps. @param offsets of these.
std::size_t sizeOf(const ImageHeader& head, osg::Image::MipmapDataType* offsets = nullptr) {
    std::size_t bytes = 0;
    for (std::uint32_t level = 0; level <= head.mipmaps; ++level) {
        if (level > 0 && offsets)
            offsets->push_back(static_cast<unsigned>(bytes));
        bytes += std::size_t(4) * static_cast<std::size_t>(std::max(head.width >> level, 1)) *
                 static_cast<std::size_t>(std::max(head.height >> level, 1));
    }
    return bytes;
}

ImageHeader headerOf(const osg::Image& image) {
    return {image.s(), image.t(), image.getNumMipmapLevels() - 1};
}

} // namespace

PaintedBytes::PaintedBytes(const std::string& work) : _key(paintSourceHash() + work) {}

std::optional<std::string> PaintedBytes::find(std::size_t maxSize) const {
    const auto bytes = userCache().find(_key);
    return bytes ? inflated(*bytes, maxSize) : std::nullopt;
}

void PaintedBytes::store(const std::string& bytes) const {
    userCache().store(_key, deflated(bytes));
}

osg::ref_ptr<osg::Image> cachedImage(const std::string& work,
                                     const std::function<osg::ref_ptr<osg::Image>()>& paint) {
    const PaintedBytes cached(work);
    if (const auto bytes = cached.find(maxImageBytes)) {
        std::size_t place = 0;
        if (osg::ref_ptr<osg::Image> image = takeImage(*bytes, place); image && place == bytes->size())
            return image;
    }
    osg::ref_ptr<osg::Image> image = paint();
    if (image) {
        std::string bytes;
        appendImage(*image, bytes);
        cached.store(bytes);
    }
    return image;
}

void appendImage(const osg::Image& image, std::string& bytes) {
    const ImageHeader head = headerOf(image);
    bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
    bytes.append(reinterpret_cast<const char*>(image.data()), sizeOf(head));
}

osg::ref_ptr<osg::Image> takeImage(const std::string& bytes, std::size_t& place) {
    ImageHeader head;
    if (bytes.size() - place < sizeof head)
        return nullptr;
    std::memcpy(&head, bytes.data() + place, sizeof head);
    place += sizeof head;
    constexpr std::int32_t maxSide = 1 << 14;
    osg::Image::MipmapDataType offsets;
    if (head.width < 1 || head.width > maxSide || head.height < 1 || head.height > maxSide ||
        head.mipmaps > 14 || bytes.size() - place < sizeOf(head))
        return nullptr;
    const std::size_t size = sizeOf(head, &offsets);
    auto* texels = new unsigned char[size];
    std::memcpy(texels, bytes.data() + place, size);
    place += size;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(head.width, head.height, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, texels,
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

std::string digestOf(const osg::Image& image) {
    Digest digest;
    digest.add(image.data(), sizeOf(headerOf(image)));
    return digest.bytes();
}

std::string digestOfFile(const std::string& path) {
    Result<std::ifstream> file = openInput(path);
    if (!file)
        return {};
    Digest digest;
    std::array<char, 65536> part{};
    while (file.value()) {
        file.value().read(part.data(), part.size());
        digest.add(part.data(), static_cast<std::size_t>(file.value().gcount()));
    }
    return file.value().bad() ? std::string() : digest.bytes();
}

} // namespace osgTreeWind
