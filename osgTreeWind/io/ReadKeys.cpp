// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ReadKeys.h>

#include <glm/trigonometric.hpp>

namespace osgTreeWind {

namespace {

template <typename T, typename... Others>
constexpr bool isOneOf = (std::is_same_v<T, Others> || ...);

/// Reads the value of one key into a member. Other types, such as arrays of a wind, have their own readers.
struct ReadMember {
    TableReader& table;
    const Key& key;
    const FileFinder& find;

    void operator()(float* member) const {
        if (key.degrees())
            table.readDegrees(key.name, *member, key.range);
        else
            table.read(key.name, *member, key.range);
    }
    void operator()(std::array<float, 4>* member) const {
        std::vector<double> numbers;
        if (table.readNumbers(key.name, numbers, member->size(), member->size(), key.range))
            for (std::size_t i = 0; i < member->size(); ++i)
                (*member)[i] = static_cast<float>(key.degrees() ? glm::radians(numbers[i]) : numbers[i]);
    }
    template <typename T>
    void operator()(std::optional<T>* member) const {
        T value{};
        (*this)(&value);
        if (table.has(key.name))
            *member = value;
    }
    void operator()(const EnumMember& word) const {
        int value = 0;
        if (table.readChoice(key.name, value, key.words))
            word.set(word.object, value);
    }
    void operator()(const NestedMember& part) const {
        table.table(key.name, [&](TableReader& t) { readKeys(t, *part.keys, part.object, find); });
    }
    void operator()(std::string* member) const {
        if (table.read(key.name, *member) && key.unit == "file")
            find(table, key.name, *member);
    }
    template <typename T>
    void operator()(T* member) const {
        if constexpr (isOneOf<T, int, double, glm::vec3, std::vector<double>>)
            table.read(key.name, *member, key.range);
        else if constexpr (isOneOf<T, bool, std::uint32_t, std::vector<std::string>>)
            table.read(key.name, *member);
    }
};

} // namespace

void readKeys(TableReader& table, const Keys& keys, void* owner, const FileFinder& find) {
    for (const Key& key : keys)
        std::visit(ReadMember{table, key, find}, key.member(owner));
}

void reportConflicts(TableReader& table, const std::vector<KeyConflict>& conflicts) {
    for (const KeyConflict& conflict : conflicts)
        table.problem(table.has(conflict.key) || !table.has(conflict.other) ? conflict.key : conflict.other,
                      conflict.message);
}

} // namespace osgTreeWind
