// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/VtkImage.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <zlib.h>

namespace osgTreeWind {

namespace {

constexpr double maxDeflateRatio = 1100.0; // the limit of deflate is 1032

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes up to the first character that is not base64. Another group may follow padding, because headers
/// and data are often encoded separately.
std::string decodeBase64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    unsigned bits = 0;
    int count = 0;
    for (char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
            continue;
        const int digit = base64Digit(c);
        if (c == '=') {
            count = 0;
            continue;
        }
        if (digit < 0)
            break;
        bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xffffff;
        count = (count + 1) % 4;
        if (count != 1)
            bytes += static_cast<char>(bits >> (count == 2 ? 4 : count == 3 ? 2 : 0) & 0xff);
    }
    return bytes;
}

/// Reads the sizes before the data.
class SizeReader {
public:
    SizeReader(std::string_view bytes, const VtkPacking& packing) : _bytes(bytes), _packing(packing) {}

    /// The next size; -1 at the end of the data.
    double next() {
        const std::size_t size = _packing.wideHeader ? 8 : 4;
        if (_bytes.size() - _at < size)
            return -1.0;
        const std::size_t at = _at;
        _at += size;
        return _packing.wideHeader ? static_cast<double>(numberAt<std::uint64_t>(_bytes, at, _packing.order))
                                   : numberAt<std::uint32_t>(_bytes, at, _packing.order);
    }

    std::size_t at() const { return _at; }

private:
    std::string_view _bytes;
    const VtkPacking& _packing;
    std::size_t _at = 0;
};

Result<std::string> inflateBlocks(std::string_view bytes, const VtkPacking& packing, double size) {
    SizeReader header(bytes, packing);
    const double blocks = header.next(), blockSize = header.next(), lastSize = header.next();
    const double unpacked = lastSize > 0.0 ? (blocks - 1.0) * blockSize + lastSize : blocks * blockSize;
    if (lastSize < 0.0 || blocks < 1.0 || blockSize < 1.0 || unpacked != size)
        return fileProblem({}, "expected compressed blocks of " + numberText(size) + " bytes together");
    if (blocks * (packing.wideHeader ? 8 : 4) > static_cast<double>(bytes.size()) ||
        size > maxDeflateRatio * static_cast<double>(bytes.size()))
        return fileProblem({}, "the data end before " + numberText(blocks) + " compressed blocks");

    if (const std::string memory =
            problemOfMemory("the unpacked data", static_cast<std::uint64_t>(2.0 * size));
        !memory.empty())
        return fileProblem({}, memory);

    SizeReader sizes = header;
    for (double i = 0; i < blocks; ++i)
        header.next();
    std::size_t from = header.at();
    std::string out(static_cast<std::size_t>(size), '\0');
    std::size_t to = 0;
    for (double i = 0; i < blocks; ++i) {
        const double packedSize = sizes.next();
        if (packedSize < 0.0 || packedSize > static_cast<double>(bytes.size() - from))
            return fileProblem({}, "the data end within compressed block " + numberText(i + 1));
        const bool last = i == blocks - 1 && lastSize > 0.0;
        uLongf length = static_cast<uLongf>(last ? lastSize : blockSize);
        const uLongf wanted = length;
        if (uncompress(reinterpret_cast<Bytef*>(&out[to]), &length,
                       reinterpret_cast<const Bytef*>(bytes.data() + from),
                       static_cast<uLong>(packedSize)) != Z_OK ||
            length != wanted)
            return fileProblem({}, "compressed block " + numberText(i + 1) + " is damaged");
        from += static_cast<std::size_t>(packedSize);
        to += wanted;
    }
    return out;
}

} // namespace

Result<std::string> unpackVtk(std::string_view packed, const VtkPacking& packing, double size) {
    const std::string decoded = packing.base64 ? decodeBase64(packed) : std::string();
    const std::string_view bytes = packing.base64 ? std::string_view(decoded) : packed;
    if (packing.zlib)
        return inflateBlocks(bytes, packing, size);
    SizeReader header(bytes, packing);
    const double found = header.next();
    if (found != size)
        return fileProblem({}, "expected " + numberText(size) + " bytes of data, found " +
                                   (found < 0.0 ? std::string("none") : numberText(found)));
    if (size > static_cast<double>(bytes.size() - header.at()))
        return fileProblem({}, "the data end before " + numberText(size) + " bytes");
    return std::string(bytes.substr(header.at(), static_cast<std::size_t>(size)));
}

} // namespace osgTreeWind
