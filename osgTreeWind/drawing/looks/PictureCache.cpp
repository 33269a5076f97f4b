// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/PictureCache.h>

#include <osgTreeWind/base/Digest.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/SourceHashes.h>
#include <osgTreeWind/base/UserCache.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>

namespace osgTreeWind {
namespace {

/// Precedes the texels of an image.
struct ImageHeader {
    std::int32_t width = 0, height = 0;
    std::uint32_t mipmaps = 0; ///< Levels below the first.
};

using Word = std::uint32_t; ///< A texel; or their number, with the highest bit for a run of equal ones.
constexpr Word runBit = Word(1) << 31;
constexpr std::size_t minRun = 3; // texels

Word wordAt(const char* bytes) {
    Word word = 0;
    std::memcpy(&word, bytes, sizeof word);
    return word;
}

void appendWord(Word word, std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// Appends texels as runs of equal ones, each by their number and one of them, and as other texels in between
/// by their number and themselves. This takes about half their size, and a tenth of the time of zlib.
void appendTexels(const char* texels, std::size_t count, std::string& bytes) {
    const auto texel = [&](std::size_t i) { return wordAt(texels + sizeof(Word) * i); };
    std::size_t others = 0; // texels before `i` that are not yet appended
    const auto appendOthers = [&](std::size_t end) {
        if (others == 0)
            return;
        appendWord(static_cast<Word>(others), bytes);
        bytes.append(texels + sizeof(Word) * (end - others), sizeof(Word) * others);
        others = 0;
    };
    for (std::size_t i = 0; i < count;) {
        std::size_t end = i + 1;
        while (end < count && texel(end) == texel(i))
            ++end;
        if (end - i < minRun) {
            others += end - i;
        } else {
            appendOthers(i);
            appendWord(static_cast<Word>(end - i) | runBit, bytes);
            appendWord(texel(i), bytes);
        }
        i = end;
    }
    appendOthers(count);
}

/// Inverse of appendTexels(), which moves the place behind them. @return whether the bytes are so many
/// texels.
bool takeTexels(const std::string& bytes, std::size_t& place, char* texels, std::size_t count) {
    while (count > 0) {
        if (bytes.size() - place < 2 * sizeof(Word))
            return false;
        const Word word = wordAt(&bytes[place]);
        const std::size_t number = word & ~runBit, size = sizeof(Word) * number;
        place += sizeof(Word);
        if (number == 0 || number > count)
            return false;
        if ((word & runBit) != 0) {
            const Word texel = wordAt(&bytes[place]);
            for (std::size_t i = 0; i < number; ++i)
                std::memcpy(texels + sizeof(Word) * i, &texel, sizeof texel);
            place += sizeof texel;
        } else {
            if (bytes.size() - place < size)
                return false;
            std::memcpy(texels, &bytes[place], size);
            place += size;
        }
        texels += size;
        count -= number;
    }
    return true;
}

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

std::optional<std::string> PaintedBytes::find() const {
    return userCache().find(_key);
}

void PaintedBytes::store(const std::string& bytes) const {
    userCache().store(_key, bytes);
}

osg::ref_ptr<osg::Image> cachedImage(const std::string& work,
                                     const std::function<osg::ref_ptr<osg::Image>()>& paint) {
    const PaintedBytes cached(work);
    osg::ref_ptr<osg::Image> image;
    if (const auto bytes = cached.find()) {
        std::size_t place = 0;
        image = takeImage(*bytes, place);
    }
    if (!image && (image = paint())) {
        std::string bytes;
        appendImage(*image, bytes);
        cached.store(bytes);
    }
    if (image)
        image->setName(work);
    return image;
}

void appendImage(const osg::Image& image, std::string& bytes) {
    const ImageHeader head = headerOf(image);
    bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
    appendTexels(reinterpret_cast<const char*>(image.data()), sizeOf(head) / sizeof(Word), bytes);
}

osg::ref_ptr<osg::Image> takeImage(const std::string& bytes, std::size_t& place) {
    ImageHeader head;
    if (bytes.size() - place < sizeof head)
        return nullptr;
    std::memcpy(&head, bytes.data() + place, sizeof head);
    place += sizeof head;
    constexpr std::int32_t maxSide = 1 << 12;
    osg::Image::MipmapDataType offsets;
    if (head.width < 1 || head.width > maxSide || head.height < 1 || head.height > maxSide ||
        head.mipmaps > 14)
        return nullptr;
    const std::size_t size = sizeOf(head, &offsets);
    std::unique_ptr<unsigned char[]> texels(new unsigned char[size]);
    if (!takeTexels(bytes, place, reinterpret_cast<char*>(texels.get()), size / sizeof(Word)))
        return nullptr;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(head.width, head.height, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, texels.release(),
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
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
