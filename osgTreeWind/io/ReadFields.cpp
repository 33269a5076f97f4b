// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ReadFields.h>

#include <glm/trigonometric.hpp>

namespace osgTreeWind {

namespace {

template <typename T, typename... Others>
constexpr bool isOneOf = (std::is_same_v<T, Others> || ...);

/// Reads the value of one key into a member. Other types, such as arrays of a wind, have their own readers.
struct ReadMember {
    TableReader& table;
    const Field& field;
    const FileFinder& find;

    void operator()(float* member) const {
        if (field.degrees())
            table.readDegrees(field.key, *member, field.range);
        else
            table.read(field.key, *member, field.range);
    }
    void operator()(std::array<float, 4>* member) const {
        std::vector<double> numbers;
        if (table.readNumbers(field.key, numbers, member->size(), member->size(), field.range))
            for (std::size_t i = 0; i < member->size(); ++i)
                (*member)[i] = static_cast<float>(field.degrees() ? glm::radians(numbers[i]) : numbers[i]);
    }
    void operator()(std::optional<bool>* member) const {
        if (bool value = false; table.read(field.key, value))
            *member = value;
    }
    void operator()(const EnumMember& word) const {
        int value = 0;
        if (table.readChoice(field.key, value, field.words))
            word.set(word.object, value);
    }
    void operator()(const NestedMember& part) const {
        table.table(field.key, [&](TableReader& t) { readFields(t, *part.fields, part.object, find); });
    }
    void operator()(std::string* member) const {
        if (table.read(field.key, *member) && field.unit == "file")
            find(table, field.key, *member);
    }
    template <typename T>
    void operator()(T* member) const {
        if constexpr (isOneOf<T, int, double, glm::vec3, std::vector<double>>)
            table.read(field.key, *member, field.range);
        else if constexpr (isOneOf<T, bool, std::uint32_t, std::vector<std::string>>)
            table.read(field.key, *member);
    }
};

} // namespace

void readFields(TableReader& table, const Fields& fields, void* owner, const FileFinder& find) {
    for (const Field& field : fields)
        std::visit(ReadMember{table, field, find}, field.member(owner));
}

void reportConflicts(TableReader& table, const std::vector<FieldConflict>& conflicts) {
    for (const FieldConflict& conflict : conflicts)
        table.problem(table.has(conflict.key) || !table.has(conflict.other) ? conflict.key : conflict.other,
                      conflict.message);
}

} // namespace osgTreeWind
