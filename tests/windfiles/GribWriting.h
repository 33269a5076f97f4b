// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Writes small GRIB files byte by byte.
namespace osgTreeWind::grib {

/// A big-endian integer of `count` octets.
inline std::string number(std::uint64_t value, std::size_t count) {
    std::string bytes;
    while (count-- > 0)
        bytes += static_cast<char>(count < sizeof value ? value >> 8 * count & 0xff : 0);
    return bytes;
}

/// The same with the sign in the first bit.
inline std::string withSign(double value, std::size_t count) {
    const auto size = static_cast<std::uint64_t>(std::llround(std::abs(value)));
    return number(value < 0.0 ? size | std::uint64_t(1) << (8 * count - 1) : size, count);
}

/// Points in longitude and latitude from the north-west, rows southward; or in Lambert projection around 25
/// N, 95 W on a sphere of 6371.229 km (edition 1: NCEP's 6371.2 km) from the south-west, rows northward.
struct Grid {
    bool lambert = false;
    int columns = 4, rows = 3;
    double longitude = 10.0, latitude = 50.0; ///< Of the first point.
    double step = 0.5;                        ///< Degrees; of Lambert's map metres.
    bool relativeToGrid = false;
    int lambertTemplate = 30; ///< Edition 2: 30, 20 (polar stereographic) or 10 (Mercator).
};

/// A field with parameter and level numbers of edition 2; `number` and `type` must be set for edition 1.
struct Field {
    int edition = 2;
    int table = 2;          ///< Edition 1: its version; 128 and 228 are ECMWF's.
    int category = 2;       ///< Edition 2.
    int number = 2;         ///< Edition 2: 2 is U and 3 is V; edition 1: 33 and 34.
    int type = 103;         ///< Of its level: above ground, of edition 1 105.
    double level = 10.0;    ///< Edition 1: a whole number.
    int day = 3, hour = 18; ///< Of June 2017, when it began.
    int lead = 0;           ///< Hours.
    int product = 0;        ///< Edition 2: template of section 4.
    int exponent = -8;      ///< Numbers are whole ones times 2 to this.
    double least = -100.0;  ///< A whole number, not above any of them.
    Grid grid;
    std::function<double(int column, int row)> value = [](int, int) { return 1.0; };
    std::function<bool(int column, int row)> missing; ///< Empty: none.
};

inline Field with(Field field, int number, std::function<double(int, int)> value) {
    field.number = number;
    field.value = std::move(value);
    return field;
}

inline std::string section2(int section, const std::string& content) {
    return number(content.size() + 5, 4) + number(static_cast<unsigned>(section), 1) + content;
}

/// Values of a field in 16 bits each, and the bitmap of available values.
inline std::string packed(const Field& field, std::string& bitmap) {
    std::string numbers;
    int bit = 0;
    bitmap.clear();
    for (int row = 0; row < field.grid.rows; ++row)
        for (int column = 0; column < field.grid.columns; ++column, ++bit) {
            const bool missing = field.missing && field.missing(column, row);
            if (bit % 8 == 0)
                bitmap += '\0';
            if (missing)
                continue;
            bitmap.back() = static_cast<char>(bitmap.back() | 0x80 >> bit % 8);
            const double whole = std::ldexp(field.value(column, row) - field.least, -field.exponent);
            numbers += number(static_cast<std::uint64_t>(std::llround(whole)), 2);
        }
    return numbers;
}

inline std::string ieee(double value) {
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof single);
    std::copy_n(reinterpret_cast<const char*>(&single), sizeof bits, reinterpret_cast<char*>(&bits));
    return number(bits, 4);
}

/// An integer below 2^24 as IBM floating point.
inline std::string ibm(double value) {
    return number((value < 0.0 ? 0x80u : 0u) | 0x46u, 1) +
           number(static_cast<std::uint64_t>(std::abs(value)), 3);
}

inline std::string grid2(const Grid& grid) {
    constexpr double micro = 1e6;
    const int flags = 0x30 | (grid.relativeToGrid ? 8 : 0);
    const auto flag = number(static_cast<unsigned>(flags), 1);
    std::string bytes = number(0, 1) + number(static_cast<unsigned>(grid.columns * grid.rows), 4) +
                        number(0, 2) +
                        number(grid.lambert ? static_cast<unsigned>(grid.lambertTemplate) : 0u, 2) +
                        number(6, 1) + number(0, 15) + number(static_cast<unsigned>(grid.columns), 4) +
                        number(static_cast<unsigned>(grid.rows), 4);
    const auto place = [&](double longitude, double latitude) {
        return withSign(latitude * micro, 4) + withSign(longitude * micro, 4);
    };
    if (!grid.lambert)
        return bytes + number(0, 4) + number(0xffffffff, 4) + place(grid.longitude, grid.latitude) + flag +
               place(grid.longitude + grid.step * (grid.columns - 1),
                     grid.latitude - grid.step * (grid.rows - 1)) +
               withSign(grid.step * micro, 4) + withSign(grid.step * micro, 4) + number(0, 1);
    bytes += place(grid.longitude, grid.latitude) + flag;
    const std::string steps = withSign(grid.step * 1e3, 4) + withSign(grid.step * 1e3, 4),
                      northward = number(0x40, 1);
    if (grid.lambertTemplate == 20)
        return bytes + withSign(60.0 * micro, 4) + withSign(265.0 * micro, 4) + steps + number(0, 1) +
               northward;
    if (grid.lambertTemplate == 10)
        return bytes + withSign(20.0 * micro, 4) + place(grid.longitude + 1.0, grid.latitude + 1.0) +
               northward + number(0, 4) + steps;
    return bytes + withSign(25.0 * micro, 4) + withSign(265.0 * micro, 4) + steps + number(0, 1) + northward +
           withSign(25.0 * micro, 4) + withSign(25.0 * micro, 4) + number(0, 8);
}

/// Sections 4 to 7 of edition 2.
inline std::string numbers2(const Field& field) {
    std::string bitmap;
    const std::string numbers = packed(field, bitmap);
    const double tenths = std::round(field.level * 10.0);
    std::string product = number(0, 2) + number(static_cast<unsigned>(field.product), 2) +
                          number(static_cast<unsigned>(field.category), 1) +
                          number(static_cast<unsigned>(field.number), 1) + number(2, 1) + number(0, 2) +
                          number(0, 3) + number(1, 1) + withSign(field.lead, 4) +
                          number(static_cast<unsigned>(field.type), 1) + number(1, 1) + withSign(tenths, 4) +
                          number(255, 1) + number(0, 5);
    if (field.product > 0)
        product += std::string(40, '\1');
    return section2(4, product) +
           section2(5, number(numbers.size() / 2, 4) + number(0, 2) + ieee(field.least) +
                           withSign(field.exponent, 2) + number(0, 2) + number(16, 1) + number(0, 1)) +
           section2(6, field.missing ? number(0, 1) + bitmap : number(255, 1)) + section2(7, numbers);
}

inline std::string message2(const std::string& sections) {
    return std::string("GRIB") + number(0, 2) + number(0, 1) + number(2, 1) +
           number(sections.size() + 20, 8) + sections + "7777";
}

/// A message of edition 2 with several fields, all at the same time and on the same grid.
inline std::string message2(const std::vector<Field>& fields) {
    const Field& field = fields.front();
    std::string sections =
        section2(1, number(7, 2) + number(0, 2) + number(2, 1) + number(1, 2) + number(2017, 2) +
                        number(6, 1) + number(static_cast<unsigned>(field.day), 1) +
                        number(static_cast<unsigned>(field.hour), 1) + number(0, 2) + number(0, 1) +
                        number(1, 1)) +
        section2(3, grid2(field.grid));
    for (const Field& each : fields)
        sections += numbers2(each);
    return message2(sections);
}

inline std::string section1(const std::string& content) {
    return number(content.size() + 3, 3) + content;
}

inline std::string message1(const Field& field) {
    const Grid& grid = field.grid;
    std::string bitmap;
    const std::string numbers = packed(field, bitmap);
    const int flags = 0x80 | (grid.relativeToGrid ? 8 : 0);
    const auto octet = [](int value) { return number(static_cast<unsigned>(value), 1); };
    const std::string product =
        section1(octet(field.table) + octet(field.table > 3 ? 98 : 7) + octet(1) + octet(255) +
                 octet(field.missing ? 0xc0 : 0x80) + octet(field.number) + octet(field.type) +
                 number(static_cast<unsigned>(field.level), 2) + octet(17) + octet(6) + octet(field.day) +
                 octet(field.hour) + octet(0) + octet(1) + octet(field.lead) + octet(0) + octet(0) +
                 number(0, 3) + octet(21) + octet(0) + number(0, 2));
    const auto place = [&](double longitude, double latitude) {
        return withSign(latitude * 1e3, 3) + withSign(longitude * 1e3, 3);
    };
    std::string definition =
        octet(0) + octet(255) + octet(grid.lambert ? 3 : 0) + number(static_cast<unsigned>(grid.columns), 2) +
        number(static_cast<unsigned>(grid.rows), 2) + place(grid.longitude, grid.latitude) + octet(flags);
    if (grid.lambert)
        definition += withSign(-95e3, 3) + withSign(grid.step, 3) + withSign(grid.step, 3) + octet(0) +
                      octet(0x40) + withSign(25e3, 3) + withSign(25e3, 3) + number(0, 8);
    else
        definition += place(grid.longitude + grid.step * (grid.columns - 1),
                            grid.latitude - grid.step * (grid.rows - 1)) +
                      withSign(grid.step * 1e3, 2) + withSign(grid.step * 1e3, 2) + octet(0) + number(0, 4);
    const std::string sections =
        product + section1(definition) +
        (field.missing ? section1(octet(-grid.columns * grid.rows & 7) + number(0, 2) + bitmap) : "") +
        section1(octet(8) + withSign(field.exponent, 2) + ibm(field.least) + octet(16) + numbers + octet(0));
    return "GRIB" + number(sections.size() + 12, 3) + octet(1) + sections + "7777";
}

inline std::string message(const Field& field) {
    return field.edition == 1 ? message1(field) : message2(std::vector<Field>{field});
}

/// U and V of a field; in edition 2 in one message, as written by NCEP.
inline std::string wind(const Field& field, const std::function<double(int, int)>& u,
                        const std::function<double(int, int)>& v) {
    if (field.edition == 2)
        return message2(std::vector<Field>{with(field, 2, u), with(field, 3, v)});
    const bool ecmwf = field.table == 128;
    return message1(with(field, ecmwf ? 131 : 33, u)) + message1(with(field, ecmwf ? 132 : 34, v));
}

} // namespace osgTreeWind::grib
