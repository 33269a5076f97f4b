// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace osgTreeWind {

/// Octets of a section, counted from 1 as GRIB's tables do; beyond its end all are 0.
class GribBytes {
public:
    explicit GribBytes(std::string_view bytes) : _bytes(bytes) {}

    std::size_t size() const { return _bytes.size(); }
    std::string_view bytes() const { return _bytes; }

    /// A whole number of up to 8 octets, the most significant first.
    std::uint64_t number(std::size_t octet, std::size_t count = 1) const {
        std::uint64_t value = 0;
        for (std::size_t i = octet - 1; i < octet - 1 + count; ++i)
            value = value << 8 | (i < _bytes.size() ? static_cast<unsigned char>(_bytes[i]) : 0u);
        return value;
    }

    /// The same with a sign in its first bit.
    double withSign(std::size_t octet, std::size_t count) const {
        const std::uint64_t sign = std::uint64_t(1) << (8 * count - 1), value = number(octet, count);
        return (value & sign ? -1.0 : 1.0) * static_cast<double>(value & ~sign);
    }

    int whole(std::size_t octet, std::size_t count = 1) const {
        return static_cast<int>(number(octet, count));
    }

private:
    std::string_view _bytes;
};

} // namespace osgTreeWind
