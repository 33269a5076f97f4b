// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>

#include <ostream>
#include <string>
#include <vector>

/// Formats values as TOML that reads back exactly.
namespace osgTreeWind {

std::string tomlText(double number);
std::string tomlText(float number); ///< Exact after reading a double and rounding to float.
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

/// Writes the keys that differ from `defaults` (null: all keys): first the keys, then the tables of
/// nested structs. @param table that contains the keys, such as "species.growth".
void writeKeys(std::ostream& output, const std::string& table, const Keys& keys, const void* owner,
               const void* defaults);
template <typename Struct>
void writeKeys(std::ostream& output, const std::string& table, const Struct& value,
               const Struct& defaults = {}) {
    writeKeys(output, table, keysOf<Struct>(), &value, &defaults);
}
/// Writes "[table]" and its keys, unless all keys have their defaults.
template <typename Struct>
void writeTable(std::ostream& output, const std::string& table, const Struct& value) {
    const Struct defaults{};
    for (const Key& key : keysOf<Struct>())
        if (!isKeyEqual(key, &value, &defaults))
            return output << "\n[" << table << "]\n", writeKeys(output, table, value, defaults);
}

} // namespace osgTreeWind
