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

struct Field;
/// What a struct says, in the order of the manual: the one place for keys, ranges, units and words.
using Fields = std::vector<Field>;

/// The fields of a struct; each has a specialization beside it.
template <typename Struct>
const Fields& fieldsOf();

/// A member that is one of a few words: an enum.
struct WordMember {
    void* object;
    int (*get)(const void*);
    void (*set)(void*, int);
};
/// A member that has fields of its own.
struct PartMember {
    void* object;
    const Fields* fields;
};
using Member =
    std::variant<bool*, std::optional<bool>*, int*, std::uint32_t*, float*, double*, glm::vec3*, glm::dvec3*,
                 glm::ivec3*, std::string*, std::vector<std::string>*, std::vector<double>*,
                 std::vector<float>*, std::vector<glm::vec3>*, std::array<float, 4>*, WordMember, PartMember>;

/// One thing that a struct says.
struct Field {
    const char* key;               ///< In a file.
    Member (*member)(void* owner); ///< Where it is in a struct.
    Range range;                   ///< Of a number, in `unit`.
    std::string doc;               ///< What it is, for the manual.
    std::string unit{};            ///< As in the manual; of "degrees" floats are in radians, a double is not.
    std::vector<std::pair<std::string, int>> words{}; ///< Of an enum, with their values.

    bool degrees() const { return unit.rfind("degrees", 0) == 0; } ///< Or degrees a metre.
    Member of(const void* owner) const { return member(const_cast<void*>(owner)); }
};

/// Two fields whose values, each in range, do not go together.
struct FieldConflict {
    std::string key;   ///< Empty: the struct as a whole.
    std::string other; ///< Empty: none.
    std::string message;
};

template <typename Struct, typename T>
Struct* ownerOf(T Struct::*);

/// Field::member of a member, or of a member of a member.
template <auto First, auto... Rest>
Member at(void* owner) {
    auto& member = static_cast<decltype(ownerOf(First))>(owner)->*First;
    using T = std::remove_reference_t<decltype(member)>;
    if constexpr (sizeof...(Rest) > 0)
        return at<Rest...>(&member);
    else if constexpr (std::is_enum_v<T>)
        return WordMember{&member,
                          [](const void* word) { return static_cast<int>(*static_cast<const T*>(word)); },
                          [](void* word, int value) { *static_cast<T*>(word) = static_cast<T>(value); }};
    else if constexpr (std::is_constructible_v<Member, T*>)
        return &member;
    else
        return PartMember{&member, &fieldsOf<T>()};
}

/// Field::words of an enum whose values count from 0.
std::vector<std::pair<std::string, int>> inOrder(const std::vector<std::string>& words);

/// The field with that key, which is there.
const Field& fieldAt(const Fields& fields, const std::string& key);

/// Ends of the range of a member that is a float: in radians where the field is in degrees.
Range memberRange(const Field& field);

/// Brings every number into its range; NaN becomes that of `usual`.
void clampFields(const Fields& fields, void* owner, const void* usual);
template <typename Struct>
Struct clampedFields(Struct value, const Struct& usual = {}) {
    clampFields(fieldsOf<Struct>(), &value, &usual);
    return value;
}

/// Adds what is out of range, with `path` and the key: "species[0].wood.density".
void checkFields(const Fields& fields, const void* owner, const std::string& path, Diagnostics& problems);
template <typename Struct>
void checkFields(const Struct& value, const std::string& path, Diagnostics& problems) {
    checkFields(fieldsOf<Struct>(), &value, path, problems);
}

/// Appends all that a struct says, to the bit: what tells it from others of its kind.
void addFieldBytes(const Fields& fields, const void* owner, std::string& bytes);
template <typename Struct>
void addFieldBytes(const Struct& value, std::string& bytes) {
    addFieldBytes(fieldsOf<Struct>(), &value, bytes);
}

/// Whether two structs say the same of one field, to the bit.
bool sameField(const Field& field, const void* a, const void* b);
/// The same of all fields.
bool sameFields(const Fields& fields, const void* a, const void* b);
template <typename Struct>
bool sameFields(const Struct& a, const Struct& b) {
    return sameFields(fieldsOf<Struct>(), &a, &b);
}

} // namespace osgTreeWind
