// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Field.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Replaces what is outside by the nearer end, and NaN.
struct Clamp {
    const Field& field;
    const Range range;
    Member usual;

    void operator()(int* number) const {
        *number = std::clamp(*number, static_cast<int>(range.min), static_cast<int>(range.max));
    }
    void operator()(float* number) const {
        *number = clampOr(*number, static_cast<float>(range.min), static_cast<float>(range.max),
                          **std::get_if<float*>(&usual));
    }
    void operator()(double* number) const {
        *number = clampOr(*number, range.min, range.max, **std::get_if<double*>(&usual));
    }
    void operator()(std::array<float, 4>* numbers) const {
        for (std::size_t i = 0; i < numbers->size(); ++i)
            (*numbers)[i] =
                clampOr((*numbers)[i], static_cast<float>(range.min), static_cast<float>(range.max),
                        (**std::get_if<std::array<float, 4>*>(&usual))[i]);
    }
    void operator()(glm::dvec3* vector) const {
        for (int i = 0; i < 3; ++i)
            (*vector)[i] =
                clampOr((*vector)[i], range.min, range.max, (**std::get_if<glm::dvec3*>(&usual))[i]);
    }
    void operator()(const PartMember& part) const {
        clampFields(*part.fields, part.object, std::get_if<PartMember>(&usual)->object);
    }
    template <typename T>
    void operator()(const T&) const {}
};

/// Says what is outside.
struct Check {
    const Field& field;
    const Range range;
    const std::string& path; ///< Of the struct.
    Diagnostics& problems;

    std::string key() const { return path.empty() ? field.key : path + '.' + field.key; }
    void add(const std::string& message) const { problems.push_back(keyProblem(key(), message)); }
    void number(double value, const char* kind, bool isAngle = false) const {
        if ((std::isfinite(value) && range.contains(value)) ||
            (!problems.empty() && problems.back().key == key()))
            return;
        const std::string limits = field.range.text(), unit = field.degrees() ? " degrees" : "";
        add(std::string("expected a ") + kind + " number" + (limits.empty() ? "" : ' ' + limits + unit) +
            ", found " + numberText(isAngle ? static_cast<float>(glm::degrees(value)) : value) + unit);
    }

    void operator()(const int* value) const { number(*value, "whole"); }
    void operator()(const float* value) const {
        number(static_cast<double>(*value), "finite", field.degrees());
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
    void operator()(const std::vector<glm::vec3>* values) const {
        std::for_each(values->begin(), values->end(), [&](const glm::vec3& value) { (*this)(&value); });
    }
    template <typename T>
    void operator()(const std::vector<T>* values) const {
        if constexpr (std::is_arithmetic_v<T>)
            for (const T value : *values)
                number(static_cast<double>(value), "finite");
    }
    void operator()(const WordMember& word) const {
        const int value = word.get(word.object);
        for (const auto& known : field.words)
            if (known.second == value)
                return;
        add("expected one of its words, found " + std::to_string(value));
    }
    void operator()(const PartMember& part) const { checkFields(*part.fields, part.object, key(), problems); }
    template <typename T>
    void operator()(const T*) const {}
};

/// Tells -0 from 0; NaN is NaN.
template <typename T>
bool sameNumber(T a, T b) {
    return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

/// Compares with the same member of another struct.
struct Same {
    Member other;

    template <typename T>
    bool operator()(const T* value) const {
        const T& b = **std::get_if<T*>(&other);
        if constexpr (std::is_floating_point_v<T>)
            return sameNumber(*value, b);
        else if constexpr (std::is_same_v<T, glm::vec3> || std::is_same_v<T, glm::dvec3>)
            return sameNumber(value->x, b.x) && sameNumber(value->y, b.y) && sameNumber(value->z, b.z);
        else if constexpr (std::is_same_v<T, std::array<float, 4>>)
            return std::equal(value->begin(), value->end(), b.begin(), sameNumber<float>);
        else
            return *value == b;
    }
    bool operator()(const WordMember& word) const {
        const WordMember& b = *std::get_if<WordMember>(&other);
        return word.get(word.object) == b.get(b.object);
    }
    bool operator()(const PartMember& part) const {
        return std::all_of(part.fields->begin(), part.fields->end(), [&](const Field& field) {
            return sameField(field, part.object, std::get_if<PartMember>(&other)->object);
        });
    }
};

/// Appends a member.
struct Append {
    std::string& bytes;

    template <typename T>
    void operator()(const T* value) const {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(value), sizeof(T));
    }
    void operator()(const std::optional<bool>* value) const {
        bytes += *value ? static_cast<char>(**value) : '\2';
    }
    void operator()(const std::string* text) const { bytes.append(*text) += '\0'; }
    template <typename T>
    void operator()(const std::vector<T>* values) const {
        const std::size_t count = values->size();
        (*this)(&count);
        for (const T& value : *values)
            (*this)(&value);
    }
    void operator()(const WordMember& word) const {
        const int value = word.get(word.object);
        (*this)(&value);
    }
    void operator()(const PartMember& part) const { addFieldBytes(*part.fields, part.object, bytes); }
};

} // namespace

std::vector<std::pair<std::string, int>> inOrder(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, int>> result;
    for (const std::string& word : words)
        result.emplace_back(word, static_cast<int>(result.size()));
    return result;
}

const Field& fieldAt(const Fields& fields, const std::string& key) {
    return *std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.key == key; });
}

Range memberRange(const Field& field) {
    const auto end = [&](double limit) {
        return static_cast<double>(static_cast<float>(field.degrees() ? glm::radians(limit) : limit));
    };
    return {end(field.range.min), end(field.range.max), field.range.aboveMin};
}

namespace {

Range rangeOf(const Field& field, const Member& member) {
    const bool isDouble =
        std::holds_alternative<double*>(member) || std::holds_alternative<glm::dvec3*>(member);
    return isDouble ? field.range : memberRange(field);
}

} // namespace

void clampFields(const Fields& fields, void* owner, const void* usual) {
    for (const Field& field : fields) {
        const Member member = field.member(owner);
        std::visit(Clamp{field, rangeOf(field, member), field.of(usual)}, member);
    }
}

void checkFields(const Fields& fields, const void* owner, const std::string& path, Diagnostics& problems) {
    for (const Field& field : fields) {
        const Member member = field.of(owner);
        std::visit(Check{field, rangeOf(field, member), path, problems}, member);
    }
}

void addFieldBytes(const Fields& fields, const void* owner, std::string& bytes) {
    for (const Field& field : fields)
        std::visit(Append{bytes}, field.of(owner));
}

bool sameField(const Field& field, const void* a, const void* b) {
    return std::visit(Same{field.of(b)}, field.of(a));
}

bool sameFields(const Fields& fields, const void* a, const void* b) {
    return std::all_of(fields.begin(), fields.end(),
                       [&](const Field& field) { return sameField(field, a, b); });
}

} // namespace osgTreeWind
