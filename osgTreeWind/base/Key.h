// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Result.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace osgTreeWind {

struct Key;
/// Describes the members of a struct in the order of the manual: keys, ranges, units and enum words.
using Keys = std::vector<Key>;

/// The keys of a struct. Each such struct specializes this function.
template <typename Struct>
const Keys& keysOf();

/// A member of enum type.
struct EnumMember {
    void* object;
    int (*get)(const void*);
    void (*set)(void*, int);
};
/// A member that is itself a struct with keys.
struct NestedMember {
    void* object;
    const Keys* keys;
};
using Member = std::variant<bool*, std::optional<bool>*, int*, std::uint32_t*, float*, double*, glm::vec3*,
                            std::optional<glm::vec3>*, glm::dvec3*, glm::ivec3*, std::string*,
                            std::vector<std::string>*, std::vector<double>*, std::vector<float>*,
                            std::vector<glm::vec3>*, std::array<float, 4>*, EnumMember, NestedMember>;

/// Describes one member of a struct.
struct Key {
    const char* name;              ///< The key in a file.
    Member (*member)(void* owner); ///< Finds the member in a struct.
    Range range;                   ///< Valid range of a number, in `unit`.
    std::string doc;               ///< Description for the manual.
    std::string unit{};            ///< For the manual. In "degrees", the members are radians.
    std::vector<std::pair<std::string, int>> words{}; ///< Words and values of an enum.

    bool degrees() const { return unit.rfind("degrees", 0) == 0; } ///< In degrees, or degrees per metre.
    Member of(const void* owner) const { return member(const_cast<void*>(owner)); }
};

/// Two values that are each in range but contradict each other.
struct KeyConflict {
    std::string key;   ///< Empty: the struct as a whole.
    std::string other; ///< Key of the second value; may be empty.
    std::string message;
};

template <typename Struct, typename T>
Struct* ownerOf(T Struct::*);

/// A Key::member function for a member, or for a member of a member.
template <auto First, auto... Rest>
Member at(void* owner) {
    auto& member = static_cast<decltype(ownerOf(First))>(owner)->*First;
    using T = std::remove_reference_t<decltype(member)>;
    if constexpr (sizeof...(Rest) > 0)
        return at<Rest...>(&member);
    else if constexpr (std::is_enum_v<T>)
        return EnumMember{&member,
                          [](const void* word) { return static_cast<int>(*static_cast<const T*>(word)); },
                          [](void* word, int value) { *static_cast<T*>(word) = static_cast<T>(value); }};
    else if constexpr (std::is_constructible_v<Member, T*>)
        return &member;
    else
        return NestedMember{&member, &keysOf<T>()};
}

/// Key::words for an enum whose values are 0, 1, 2, ...
std::vector<std::pair<std::string, int>> numberedFromZero(const std::vector<std::string>& words);

/// The key with that name, which must exist.
const Key& keyAt(const Keys& keys, const std::string& name);

/// The range of a float member, in radians if the key is in degrees.
Range memberRange(const Key& key);

/// Clamps every number to its range, and replaces NaN by the value in `defaults`.
void clampKeys(const Keys& keys, void* owner, const void* defaults);
template <typename Struct>
Struct clampedKeys(Struct value, const Struct& defaults = {}) {
    clampKeys(keysOf<Struct>(), &value, &defaults);
    return value;
}

/// Appends a problem for each value out of range, with `path` and its key: "species[0].wood.density".
void checkKeys(const Keys& keys, const void* owner, const std::string& path, Diagnostics& problems);
template <typename Struct>
void checkKeys(const Struct& value, const std::string& path, Diagnostics& problems) {
    checkKeys(keysOf<Struct>(), &value, path, problems);
}

/// Appends the exact values of all members with keys, for use as a cache key.
void addKeyBytes(const Keys& keys, const void* owner, std::string& bytes);
template <typename Struct>
void addKeyBytes(const Struct& value, std::string& bytes) {
    addKeyBytes(keysOf<Struct>(), &value, bytes);
}

/// Whether a key has the same value in two structs. Distinguishes -0 from 0; NaN equals NaN.
bool isKeyEqual(const Key& key, const void* a, const void* b);
/// Whether isKeyEqual() holds for all keys.
bool areKeysEqual(const Keys& keys, const void* a, const void* b);
template <typename Struct>
bool areKeysEqual(const Struct& a, const Struct& b) {
    return areKeysEqual(keysOf<Struct>(), &a, &b);
}

} // namespace osgTreeWind
