// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Deflate.h>

#include <zlib.h>

#include <cstdint>
#include <cstring>

namespace osgTreeWind {
namespace {

using Size = std::uint64_t; // precedes the compressed bytes

} // namespace

std::string deflated(const std::string& plain) {
    const Size plainSize = plain.size();
    uLongf size = compressBound(plain.size());
    std::string packed(sizeof plainSize + size, '\0');
    std::memcpy(packed.data(), &plainSize, sizeof plainSize);
    compress2(reinterpret_cast<Bytef*>(packed.data() + sizeof plainSize), &size,
              reinterpret_cast<const Bytef*>(plain.data()), plain.size(), Z_BEST_SPEED);
    packed.resize(sizeof plainSize + size);
    return packed;
}

std::optional<std::string> inflated(const std::string& bytes, std::size_t maxSize) {
    Size plainSize = 0;
    if (bytes.size() < sizeof plainSize)
        return std::nullopt;
    std::memcpy(&plainSize, bytes.data(), sizeof plainSize);
    if (plainSize > maxSize)
        return std::nullopt;
    std::string plain(plainSize, '\0');
    uLongf size = plain.size();
    if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data() + sizeof plainSize),
                   bytes.size() - sizeof plainSize) != Z_OK ||
        size != plain.size())
        return std::nullopt;
    return plain;
}

} // namespace osgTreeWind
