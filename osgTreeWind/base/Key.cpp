// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Key.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Clamps a member to its range and replaces NaN.
struct Clamp {
    const Key& key;
    const Range range;
    Member defaults;

    void operator()(int* number) const {
        *number = std::clamp(*number, static_cast<int>(range.min), static_cast<int>(range.max));
    }
    void operator()(float* number) const {
        *number = clampOr(*number, static_cast<float>(range.min), static_cast<float>(range.max),
                          **std::get_if<float*>(&defaults));
    }
    void operator()(double* number) const {
        *number = clampOr(*number, range.min, range.max, **std::get_if<double*>(&defaults));
    }
    void operator()(std::array<float, 4>* numbers) const {
        for (std::size_t i = 0; i < numbers->size(); ++i)
            (*numbers)[i] =
                clampOr((*numbers)[i], static_cast<float>(range.min), static_cast<float>(range.max),
                        (**std::get_if<std::array<float, 4>*>(&defaults))[i]);
    }
    void operator()(glm::dvec3* vector) const {
        for (int i = 0; i < 3; ++i)
            (*vector)[i] =
                clampOr((*vector)[i], range.min, range.max, (**std::get_if<glm::dvec3*>(&defaults))[i]);
    }
    void operator()(const NestedMember& part) const {
        clampKeys(*part.keys, part.object, std::get_if<NestedMember>(&defaults)->object);
    }
    template <typename T>
    void operator()(const T&) const {}
};

/// Reports a member that is out of range.
struct Check {
    const Key& key;
    const Range range;
    const std::string& path; ///< Path of the struct.
    Diagnostics& problems;

    std::string fullName() const { return path.empty() ? key.name : path + '.' + key.name; }
    void add(const std::string& message) const { problems.push_back(keyProblem(fullName(), message)); }
    void number(double value, const char* kind, bool isAngle = false) const {
        if ((std::isfinite(value) && range.contains(value)) ||
            (!problems.empty() && problems.back().key == fullName()))
            return;
        const std::string limits = key.range.text(), unit = key.degrees() ? " degrees" : "";
        add(std::string("expected a ") + kind + " number" + (limits.empty() ? "" : ' ' + limits + unit) +
            ", found " + numberText(isAngle ? static_cast<float>(glm::degrees(value)) : value) + unit);
    }

    void operator()(const int* value) const { number(*value, "whole"); }
    void operator()(const float* value) const {
        number(static_cast<double>(*value), "finite", key.degrees());
    }
    void operator()(const double* value) const { number(*value, "finite"); }
    void operator()(const std::array<float, 4>* values) const {
        std::for_each(values->begin(), values->end(), [&](const float& value) { (*this)(&value); });
    }
    template <typename T>
    void operator()(const glm::vec<3, T>* value) const {
        for (int i = 0; i < 3; ++i)
            number(static_cast<double>((*value)[i]), "finite");
    }
    void operator()(const std::optional<glm::vec3>* value) const {
        if (*value)
            (*this)(&**value);
    }
    void operator()(const std::vector<glm::vec3>* values) const {
        std::for_each(values->begin(), values->end(), [&](const glm::vec3& value) { (*this)(&value); });
    }
    template <typename T>
    void operator()(const std::vector<T>* values) const {
        if constexpr (std::is_arithmetic_v<T>)
            for (const T value : *values)
                number(static_cast<double>(value), "finite");
    }
    void operator()(const EnumMember& word) const {
        const int value = word.get(word.object);
        for (const auto& known : key.words)
            if (known.second == value)
                return;
        add("expected a value of the enumeration, found " + std::to_string(value));
    }
    void operator()(const NestedMember& part) const {
        checkKeys(*part.keys, part.object, fullName(), problems);
    }
    template <typename T>
    void operator()(const T*) const {}
};

template <typename T>
bool isNumberEqual(T a, T b) {
    return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

/// Compares a member with the same member of another struct.
struct Equal {
    Member other;

    template <typename T>
    bool operator()(const T* value) const {
        const T& b = **std::get_if<T*>(&other);
        if constexpr (std::is_floating_point_v<T>)
            return isNumberEqual(*value, b);
        else if constexpr (std::is_same_v<T, glm::vec3> || std::is_same_v<T, glm::dvec3>)
            return isNumberEqual(value->x, b.x) && isNumberEqual(value->y, b.y) &&
                   isNumberEqual(value->z, b.z);
        else if constexpr (std::is_same_v<T, std::array<float, 4>>)
            return std::equal(value->begin(), value->end(), b.begin(), isNumberEqual<float>);
        else
            return *value == b;
    }
    bool operator()(const EnumMember& word) const {
        const EnumMember& b = *std::get_if<EnumMember>(&other);
        return word.get(word.object) == b.get(b.object);
    }
    bool operator()(const NestedMember& part) const {
        return std::all_of(part.keys->begin(), part.keys->end(), [&](const Key& key) {
            return isKeyEqual(key, part.object, std::get_if<NestedMember>(&other)->object);
        });
    }
};

/// Appends the bytes of a member.
struct Append {
    std::string& bytes;

    template <typename T>
    void operator()(const T* value) const {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(value), sizeof(T));
    }
    template <typename T>
    void operator()(const std::optional<T>* value) const {
        bytes += value->has_value() ? '\1' : '\0';
        if (*value)
            (*this)(&**value);
    }
    void operator()(const std::string* text) const { bytes.append(*text) += '\0'; }
    template <typename T>
    void operator()(const std::vector<T>* values) const {
        const std::size_t count = values->size();
        (*this)(&count);
        for (const T& value : *values)
            (*this)(&value);
    }
    void operator()(const EnumMember& word) const {
        const int value = word.get(word.object);
        (*this)(&value);
    }
    void operator()(const NestedMember& part) const { addKeyBytes(*part.keys, part.object, bytes); }
};

} // namespace

std::vector<std::pair<std::string, int>> numberedFromZero(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, int>> result;
    for (const std::string& word : words)
        result.emplace_back(word, static_cast<int>(result.size()));
    return result;
}

const Key& keyAt(const Keys& keys, const std::string& name) {
    return *std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
}

Range memberRange(const Key& key) {
    const auto end = [&](double limit) {
        return static_cast<double>(static_cast<float>(key.degrees() ? glm::radians(limit) : limit));
    };
    return {end(key.range.min), end(key.range.max), key.range.aboveMin};
}

namespace {

Range rangeOf(const Key& key, const Member& member) {
    const bool isDouble =
        std::holds_alternative<double*>(member) || std::holds_alternative<glm::dvec3*>(member);
    return isDouble ? key.range : memberRange(key);
}

} // namespace

void clampKeys(const Keys& keys, void* owner, const void* defaults) {
    for (const Key& key : keys) {
        const Member member = key.member(owner);
        std::visit(Clamp{key, rangeOf(key, member), key.of(defaults)}, member);
    }
}

void checkKeys(const Keys& keys, const void* owner, const std::string& path, Diagnostics& problems) {
    for (const Key& key : keys) {
        const Member member = key.of(owner);
        std::visit(Check{key, rangeOf(key, member), path, problems}, member);
    }
}

void addKeyBytes(const Keys& keys, const void* owner, std::string& bytes) {
    for (const Key& key : keys)
        std::visit(Append{bytes}, key.of(owner));
}

bool isKeyEqual(const Key& key, const void* a, const void* b) {
    return std::visit(Equal{key.of(b)}, key.of(a));
}

bool areKeysEqual(const Keys& keys, const void* a, const void* b) {
    return std::all_of(keys.begin(), keys.end(), [&](const Key& key) { return isKeyEqual(key, a, b); });
}

} // namespace osgTreeWind
