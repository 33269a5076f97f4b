// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/PictureSize.h>

#include <string>
#include <string_view>

namespace osgTreeWind {
namespace {

/// Reads a big-endian number of `count` bytes; 0 past the end.
double bigEndian(std::istream& file, int count) {
    double number = 0.0;
    for (; count > 0; --count) {
        const int byte = file.get();
        if (byte < 0)
            return 0.0;
        number = 256.0 * number + byte;
    }
    return number;
}

/// Skips JPEG segments up to the one that starts a frame.
std::optional<glm::dvec2> sizeOfJpeg(std::istream& file) {
    while (file.get() == 0xff) {
        int marker = file.get();
        while (marker == 0xff) // padding
            marker = file.get();
        const double length = bigEndian(file, 2);
        const bool startsFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (startsFrame) {
            file.ignore(1); // bits of a sample
            const double height = bigEndian(file, 2), width = bigEndian(file, 2);
            return glm::dvec2(width, height);
        }
        if (length < 2.0)
            break;
        file.ignore(static_cast<std::streamsize>(length) - 2);
    }
    return std::nullopt;
}

} // namespace

std::optional<glm::dvec2> pictureSize(std::istream& file) {
    constexpr std::string_view png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), jpeg("\xff\xd8");
    std::string head(png.size(), '\0');
    file.read(&head[0], static_cast<std::streamsize>(head.size()));
    if (head == png) {
        const double width = bigEndian(file, 4), height = bigEndian(file, 4);
        return glm::dvec2(width, height);
    }
    if (head.compare(0, jpeg.size(), jpeg) != 0)
        return std::nullopt;
    file.clear();
    file.seekg(static_cast<std::streamoff>(jpeg.size()));
    return sizeOfJpeg(file);
}

} // namespace osgTreeWind
