// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>

#include <ostream>
#include <string>
#include <vector>

/// Values as TOML that read back the same, to the bit.
namespace osgTreeWind {

std::string tomlText(double number);
std::string tomlText(float number); ///< Read as a double and rounded.
std::string tomlText(const std::string& text);

inline std::string tomlText(int number) {
    return std::to_string(number);
}
template <typename T>
std::string tomlText(const glm::vec<3, T>& v) {
    return '[' + tomlText(v.x) + ", " + tomlText(v.y) + ", " + tomlText(v.z) + ']';
}
/// "[1, 2]".
template <typename T>
std::string tomlText(const std::vector<T>& values) {
    std::string text;
    for (const T& value : values)
        text += (text.empty() ? "" : ", ") + tomlText(value);
    return '[' + text + ']';
}

/// Writes the keys that are not as in `usual` (null: all), then tables of those parts that are not.
/// @param table that the keys are in, as "species.growth".
void writeFields(std::ostream& output, const std::string& table, const Fields& fields, const void* owner,
                 const void* usual);
template <typename Struct>
void writeFields(std::ostream& output, const std::string& table, const Struct& value,
                 const Struct& usual = {}) {
    writeFields(output, table, fieldsOf<Struct>(), &value, &usual);
}
/// The same below "[table]", which is left out where nothing would be in it.
template <typename Struct>
void writeTable(std::ostream& output, const std::string& table, const Struct& value) {
    const Struct usual{};
    for (const Field& field : fieldsOf<Struct>())
        if (!sameField(field, &value, &usual))
            return output << "\n[" << table << "]\n", writeFields(output, table, value, usual);
}

/// Why a document cannot name a file; empty where it can.
std::string problemOfFile(const std::string& file);

} // namespace osgTreeWind
