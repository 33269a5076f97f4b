// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TomlText.h>

#include <osgTreeWind/system/Path.h>

#include <glm/trigonometric.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// The shortest decimal text with at least six digits whose value `isEqual` accepts.
template <typename IsEqual>
std::string shortest(double number, const IsEqual& isEqual) {
    if (number == 0.0)
        return std::signbit(number) ? "-0.0" : "0";
    for (int digits = 6;; ++digits) {
        char text[32];
        char* const end =
            std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits).ptr;
        double read = 0.0;
        std::from_chars(text, end, read);
        if (digits == 17 || isEqual(read))
            return {text, end};
    }
}

/// Formats the value of a key; empty if it need not be written.
struct ValueText {
    const Key& key;

    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    template <typename T>
    std::string operator()(const std::optional<T>* value) const {
        return value->has_value() ? (*this)(&**value) : "";
    }
    std::string operator()(const float* value) const {
        const auto isEqual = [&](double read) {
            return static_cast<float>(key.degrees() ? glm::radians(read) : read) == *value &&
                   key.range.contains(read);
        };
        const double number = static_cast<double>(*value);
        return shortest(key.degrees() ? glm::degrees(number) : number, isEqual);
    }
    std::string operator()(const std::array<float, 4>* values) const {
        std::string text;
        for (const float& value : *values)
            text += (text.empty() ? "[" : ", ") + (*this)(&value);
        return text + ']';
    }
    std::string operator()(const std::string* value) const {
        if (value->empty() || key.unit != "file")
            return value->empty() ? "" : tomlText(*value);
        return tomlText(absolutePath(*value));
    }
    template <typename T>
    std::string operator()(const std::vector<T>* values) const {
        return values->empty() ? "" : tomlText(*values);
    }
    std::string operator()(const EnumMember& word) const {
        for (const auto& [text, value] : key.words)
            if (value == word.get(word.object))
                return tomlText(text);
        return {};
    }
    std::string operator()(const NestedMember&) const { return {}; }
    std::string operator()(const std::uint32_t* value) const { return std::to_string(*value); }
    template <typename T>
    std::string operator()(const T* value) const {
        return tomlText(*value);
    }
};

} // namespace

std::string tomlText(double number) {
    return shortest(number, [&](double read) { return read == number; });
}

std::string tomlText(float number) {
    return shortest(static_cast<double>(number),
                    [&](double read) { return static_cast<float>(read) == number; });
}

std::string tomlText(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            constexpr const char* digits = "0123456789abcdef";
            quoted += std::string("\\u00") + digits[byte >> 4] + digits[byte & 15];
        } else {
            quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
        }
    }
    return quoted + '"';
}

void writeKeys(std::ostream& output, const std::string& table, const Keys& keys, const void* owner,
               const void* defaults) {
    const auto differs = [&](const Key& key) { return !defaults || !isKeyEqual(key, owner, defaults); };
    for (const Key& key : keys)
        if (differs(key))
            if (const std::string text = std::visit(ValueText{key}, key.of(owner)); !text.empty())
                output << key.name << " = " << text << '\n';
    for (const Key& key : keys) {
        const Member member = key.of(owner);
        const auto part = std::get_if<NestedMember>(&member);
        if (!part || !differs(key))
            continue;
        const std::string path = table + '.' + key.name;
        const Member other = defaults ? key.of(defaults) : Member();
        output << "\n[" << path << "]\n";
        writeKeys(output, path, *part->keys, part->object,
                  defaults ? std::get_if<NestedMember>(&other)->object : nullptr);
    }
}

} // namespace osgTreeWind
