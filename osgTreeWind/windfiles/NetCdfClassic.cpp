// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/NetCdfClassic.h>

#include <osgTreeWind/windfiles/ByteOrder.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

namespace {

enum List : std::uint32_t { Dimensions = 10, Variables = 11, Attributes = 12 };

/// Walks through the header; `good` turns false where it does not add up.
class Header {
public:
    explicit Header(std::string_view bytes) : _bytes(bytes), _version(bytes[3]) {
        count(); // records
        list(Dimensions);
        list(Attributes);
        list(Variables);
    }

    bool good = true;
    std::size_t at = 4;

private:
    void skip(std::uint64_t size) {
        if (size > _bytes.size() - at)
            good = false;
        else
            at += static_cast<std::size_t>(size);
    }

    template <typename T>
    T number() {
        const std::size_t begin = at;
        skip(sizeof(T));
        return good ? numberAt<T>(_bytes, begin, ByteOrder::Big) : T(0);
    }

    std::uint64_t count() { return _version == 5 ? number<std::uint64_t>() : number<std::uint32_t>(); }

    /// Steps over values that are padded to four bytes.
    void values(std::uint64_t number, std::uint64_t size) {
        if (number > _bytes.size())
            good = false;
        else
            skip((number * size + 3) / 4 * 4);
    }

    void list(List expected) {
        const auto kind = number<std::uint32_t>();
        const std::uint64_t members = count();
        good = good && (kind == expected || (kind == 0 && members == 0)) && members <= _bytes.size();
        for (std::uint64_t i = 0; i < members && good; ++i) {
            values(count(), 1); // name
            if (expected == Dimensions)
                _lengths.push_back(count());
            else if (expected == Attributes)
                attribute();
            else
                variable();
        }
    }

    void attribute() {
        static constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        const auto type = number<std::uint32_t>();
        const std::uint64_t number = count();
        if (type < 1 || type > 11)
            good = false;
        else
            values(number, sizes[type]);
    }

    void variable() {
        const std::uint64_t dimensions = count();
        for (std::uint64_t i = 0; i < dimensions && good; ++i) {
            const std::uint64_t id = count();
            // Only a first dimension may grow; libnetcdf divides by the length of any other one.
            good = good && id < _lengths.size() && (i == 0 || _lengths[id] > 0);
        }
        list(Attributes);
        const auto type = number<std::uint32_t>();
        good = good && type >= 1 && type <= 11; // libnetcdf divides by the size of any other one, 0
        count();                                // size
        skip(_version == 1 ? 4 : 8);
    }

    std::string_view _bytes;
    int _version;
    std::vector<std::uint64_t> _lengths; // of the dimensions; 0: grows with each record
};

} // namespace

std::string problemOfNetCdfHeader(std::string_view bytes) {
    if (bytes.size() < 4 || bytes.substr(0, 3) != "CDF")
        return {};
    const Header header(bytes);
    return header.good ? std::string() : "the NetCDF header is damaged at byte " + std::to_string(header.at);
}

} // namespace osgTreeWind
