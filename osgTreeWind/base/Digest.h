// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace osgTreeWind {

/// A hash of 128 bits over much data, for cache keys. Not against forgery.
class Digest {
public:
    void add(const void* bytes, std::size_t size) {
        const auto* at = static_cast<const unsigned char*>(bytes);
        mix(size);
        for (; size >= sizeof(std::uint64_t); at += sizeof(std::uint64_t), size -= sizeof(std::uint64_t))
            mix(wordAt(at, sizeof(std::uint64_t)));
        if (size > 0)
            mix(wordAt(at, size));
    }
    /// @param value without padding.
    template <typename T>
    void add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(&value, sizeof value);
    }
    /// @param values without padding.
    template <typename T>
    void add(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(values.data(), sizeof(T) * values.size());
    }

    /// 16 bytes.
    std::string bytes() const {
        const std::uint64_t words[2] = {finished(_first + _second), finished(_second ^ _first >> 1)};
        return std::string(reinterpret_cast<const char*>(words), sizeof words);
    }

private:
    static std::uint64_t wordAt(const unsigned char* at, std::size_t size) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, size);
        return word;
    }
    static std::uint64_t rotated(std::uint64_t word, int bits) { return word << bits | word >> (64 - bits); }
    /// The steps are those of MurmurHash3 (Appleby 2011).
    void mix(std::uint64_t word) {
        constexpr std::uint64_t one = 0x87c37b91114253d5ull, two = 0x4cf5ad432745937full;
        _first = rotated(_first ^ rotated(word * one, 31) * two, 27) * 5 + _second;
        _second = rotated(_second ^ rotated(word * two, 33) * one, 31) * 5 + _first;
    }
    static std::uint64_t finished(std::uint64_t word) {
        word = (word ^ word >> 33) * 0xff51afd7ed558ccdull;
        word = (word ^ word >> 33) * 0xc4ceb9fe1a85ec53ull;
        return word ^ word >> 33;
    }

    std::uint64_t _first = 0x52dce729, _second = 0x38495ab5;
};

} // namespace osgTreeWind
