// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TableReader.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/NameMatching.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/io/Toml.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/places/UnitSize.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>

namespace osgTreeWind {

namespace {

/// The value for messages: 'the text "abc"', '3', 'a table'.
std::string describe(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>())
        return "the text " + inQuotes(*text);
    if (const auto number = node.value_exact<std::int64_t>())
        return std::to_string(*number);
    if (const auto number = node.value_exact<double>())
        return numberText(*number);
    if (const auto flag = node.value_exact<bool>())
        return *flag ? "true" : "false";
    return node.is_table() ? "a table" : node.is_array() ? "an array" : "a date or time";
}

/// A problem in the document, or in a setting, whose nodes have a path.
Diagnostic problemAt(const toml::source_region& source, const ReadLog& log, const std::string& key,
                     const std::string& message) {
    return {source.path ? *source.path : log.file, static_cast<int>(source.begin.line),
            static_cast<int>(source.begin.column), key, message};
}

/// A problem for keys with so many parts (a.b.c.d) that the recursion of toml++ could overflow the stack.
std::optional<Diagnostic> problemOfDepth(const std::string& text, const ReadLog& log) {
    constexpr int maxDots = 200;
    int dots = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool isOfKey = std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-.\"' \t", c);
        dots = isOfKey && c ? dots + (c == '.') : 0;
        if (dots > maxDots) {
            const TextPosition position = positionInText(text, i);
            return Diagnostic{
                log.file, position.line, position.column, {}, "expected keys of at most 200 parts"};
        }
    }
    return std::nullopt;
}

/// Parses "KEY=VALUE" as a document. A value that is not TOML is a text.
Result<toml::table> parseSetting(const std::string& setting) {
    const std::string name = "setting " + inQuotes(setting);
    Result<toml::table> parsed = parseToml(setting, name);
    const std::size_t equals = setting.find('=');
    if (parsed || equals == std::string::npos)
        return parsed;
    return parseToml(setting.substr(0, equals + 1) + tomlText(setting.substr(equals + 1)), name);
}

void merge(toml::table& document, toml::table& settings) {
    for (auto&& [key, node] : settings) {
        toml::table* const existing = document[key].as_table();
        if (existing && node.is_table())
            merge(*existing, *node.as_table());
        else
            node.visit([&, &key = key](auto& value) { document.insert_or_assign(key, std::move(value)); });
    }
}

} // namespace

void TableReader::readDocument(const std::string& text, ReadLog& log, const Section& root) {
    if (auto problem = problemOfDepth(text, log))
        return log.add(std::move(*problem));
    Result<toml::table> document = parseToml(text);
    if (!document)
        return log.add(document.problems().front());
    for (const std::string& setting : log.settings) {
        Result<toml::table> set = parseSetting(setting);
        if (!set)
            return log.add(set.problems().front());
        merge(document.value(), set.value());
    }
    TableReader reader(document.value(), "", log);
    root(reader);
    reader.reportUnknown();
}

TableReader::TableReader(const toml::table& table, std::string path, ReadLog& log)
    : _table(table), _path(std::move(path)), _log(log) {}

std::string TableReader::dotted(const std::string& key) const {
    return _path.empty() || key.empty() ? _path + key : _path + '.' + key;
}

const toml::node* TableReader::find(const std::string& key) {
    if (_requestedKeys.insert(key).second)
        _log.keys.insert(dotted(key));
    return _table.get(key);
}

bool TableReader::has(const std::string& key) const {
    return _table.contains(key);
}

bool TableReader::hasText(const std::string& key, const std::string& text) const {
    const toml::node* node = _table.get(key);
    return node && node->value_exact<std::string>() == text;
}

bool TableReader::hasArray(const std::string& key) const {
    const toml::node* node = _table.get(key);
    return node && node->is_array();
}

std::vector<std::string> TableReader::texts(const std::string& key) const {
    std::vector<std::string> texts;
    const auto add = [&](const toml::node& node) {
        if (const auto text = node.value_exact<std::string>(); text && !text->empty())
            texts.push_back(*text);
    };
    if (const toml::table* const table = _table[key].as_table())
        for (const auto& [name, node] : *table) {
            add(node);
            if (const toml::array* const array = node.as_array())
                for (const toml::node& element : *array)
                    add(element);
        }
    return texts;
}

void TableReader::problemAt(const toml::node& node, const std::string& key, const std::string& message) {
    _log.add(osgTreeWind::problemAt(node.source(), _log, dotted(key), message));
}

void TableReader::problem(const std::string& key, const std::string& message) {
    const toml::node* node = key.empty() ? nullptr : _table.get(key);
    problemAt(node ? *node : _table, key, message);
}

bool TableReader::reportMissing(const std::string& key) {
    if (!has(key))
        problemAt(_table, key, "missing");
    return false;
}

bool TableReader::readNumber(const toml::node& node, const std::string& key, double& field,
                             const Range& range) {
    double number = 0.0;
    if (const auto whole = node.value_exact<std::int64_t>())
        number = static_cast<double>(*whole);
    else if (const auto real = node.value_exact<double>())
        number = *real;
    else {
        problemAt(node, key, "expected a number, found " + describe(node));
        return false;
    }
    if (!std::isfinite(number) || !range.contains(number)) {
        const std::string allowed = range.text();
        problemAt(node, key,
                  "expected a finite number" + (allowed.empty() ? "" : ' ' + allowed) + ", found " +
                      describe(node));
        return false;
    }
    field = number;
    return true;
}

bool TableReader::read(const std::string& key, double& field, const Range& range) {
    const toml::node* node = find(key);
    return node && readNumber(*node, key, field, range);
}

bool TableReader::read(const std::string& key, float& field, const Range& range) {
    double number = 0.0;
    if (!read(key, number, range))
        return false;
    field = static_cast<float>(number);
    return true;
}

bool TableReader::readDegrees(const std::string& key, float& radians, const Range& range) {
    double degrees = 0.0;
    if (!read(key, degrees, range))
        return false;
    radians = static_cast<float>(glm::radians(degrees));
    return true;
}

template <typename TomlType, typename T, typename IsValid>
bool TableReader::readExact(const std::string& key, T& field, const std::string& expected, IsValid isValid) {
    const toml::node* node = find(key);
    if (!node)
        return false;
    auto value = node->value_exact<TomlType>();
    if (!value || !isValid(*value)) {
        problemAt(*node, key, "expected " + expected + ", found " + describe(*node));
        return false;
    }
    field = static_cast<T>(std::move(*value));
    return true;
}

bool TableReader::read(const std::string& key, int& field, const Range& range) {
    const Range allowed = {std::max<double>(range.min, std::numeric_limits<int>::min()),
                           std::min<double>(range.max, std::numeric_limits<int>::max()), range.aboveMin};
    return readExact<std::int64_t>(key, field, "a whole number " + allowed.text(), [&](std::int64_t whole) {
        return allowed.contains(static_cast<double>(whole));
    });
}

bool TableReader::read(const std::string& key, std::uint32_t& field) {
    return readExact<std::int64_t>(key, field, "a whole number in [0, 4294967295]", [](std::int64_t whole) {
        return whole >= 0 && whole <= std::numeric_limits<std::uint32_t>::max();
    });
}

bool TableReader::read(const std::string& key, bool& field) {
    return readExact<bool>(key, field, "true or false", [](bool) { return true; });
}

bool TableReader::read(const std::string& key, std::string& field) {
    return readExact<std::string>(key, field, "a text in quotes",
                                  [](const std::string& text) { return !text.empty(); });
}

std::optional<double> TableReader::readUnit(const std::string& key, Dimension dimension, std::string* name) {
    std::string text;
    if (!read(key, text))
        return std::nullopt;
    const Result<double> size = sizeOfUnit(dimension, text);
    if (!size) {
        problem(key, size.problems().front().message);
        return std::nullopt;
    }
    if (name)
        *name = text;
    return size.value();
}

bool TableReader::readScalar(const std::string& key, std::string& field) {
    const toml::node* node = find(key);
    if (!node)
        return false;
    if (const auto text = node->value_exact<std::string>()) {
        field = *text;
    } else if (node->is_date() || node->is_date_time()) {
        std::ostringstream iso;
        if (const auto date = node->value_exact<toml::date>())
            iso << *date;
        else
            iso << *node->value_exact<toml::date_time>();
        field = iso.str();
    } else if (double number = 0.0; readNumber(*node, key, number, {})) {
        field = numberText(number);
    } else {
        return false;
    }
    return true;
}

bool TableReader::readArray(const toml::node& node, const std::string& key, std::vector<double>& field,
                            std::size_t minCount, std::size_t maxCount, const Range& range) {
    const toml::array* array = node.as_array();
    if (!array || array->size() < minCount || array->size() > maxCount) {
        const std::string count = maxCount == SIZE_MAX ? std::string()
                                  : minCount == maxCount
                                      ? std::to_string(minCount) + ' '
                                      : std::to_string(minCount) + " to " + std::to_string(maxCount) + ' ';
        problemAt(node, key,
                  "expected an array of " + count + "numbers, found " +
                      (!array           ? describe(node)
                       : array->empty() ? "none"
                                        : std::to_string(array->size())));
        return false;
    }
    std::vector<double> numbers(array->size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!readNumber((*array)[i], key, numbers[i], range))
            return false;
    field = std::move(numbers);
    return true;
}

bool TableReader::readNumbers(const std::string& key, std::vector<double>& field, std::size_t minCount,
                              std::size_t maxCount, const Range& range) {
    const toml::node* node = find(key);
    return node && readArray(*node, key, field, minCount, maxCount, range);
}

bool TableReader::readRows(const std::string& key, std::vector<std::vector<double>>& field, std::size_t width,
                           const Range& range) {
    const toml::node* node = find(key);
    if (!node)
        return false;
    const toml::array* array = node->as_array();
    if (!array || array->empty()) {
        problemAt(*node, key, "expected an array of arrays of " + std::to_string(width) + " numbers");
        return false;
    }
    std::vector<std::vector<double>> rows(array->size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!readArray((*array)[i], key, rows[i], width, width, range))
            return false;
    field = std::move(rows);
    return true;
}

bool TableReader::read(const std::string& key, std::vector<double>& field, const Range& range) {
    return readNumbers(key, field, 1, SIZE_MAX, range);
}

bool TableReader::read(const std::string& key, glm::vec3& field, const Range& range) {
    std::vector<double> numbers;
    if (!readNumbers(key, numbers, 3, 3, range))
        return false;
    field = glm::vec3(numbers[0], numbers[1], numbers[2]);
    return true;
}

bool TableReader::read(const std::string& key, std::vector<std::string>& field) {
    const toml::node* node = find(key);
    if (!node)
        return false;
    const toml::array* array = node->as_array();
    if (!array) {
        problemAt(*node, key, "expected an array of texts, found " + describe(*node));
        return false;
    }
    std::vector<std::string> texts;
    for (const toml::node& element : *array) {
        texts.push_back(element.value_exact<std::string>().value_or(""));
        if (texts.back().empty()) {
            problemAt(element, key, "expected a text in quotes, found " + describe(element));
            return false;
        }
    }
    field = std::move(texts);
    return true;
}

std::size_t TableReader::readWord(const std::string& key, const std::vector<std::string>& words) {
    const toml::node* node = find(key);
    if (!node)
        return words.size();
    const auto text = node->value_exact<std::string>();
    const auto found = text ? std::find(words.begin(), words.end(), *text) : words.end();
    if (found == words.end())
        problemAt(*node, key, "expected " + alternatives(words) + ", found " + describe(*node));
    return static_cast<std::size_t>(found - words.begin());
}

void TableReader::readSection(const toml::node& node, const std::string& key, const Section& section) {
    const toml::table* table = node.as_table();
    if (!table)
        return problemAt(node, key, "expected a table, found " + describe(node));
    TableReader reader(*table, dotted(key), _log);
    section(reader);
    reader.reportUnknown();
}

void TableReader::table(const std::string& key, const Section& section) {
    if (const toml::node* node = find(key))
        readSection(*node, key, section);
}

void TableReader::tables(const std::string& key, const Section& section) {
    const toml::node* node = find(key);
    if (!node)
        return;
    const toml::array* array = node->as_array();
    if (!array)
        return readSection(*node, key, section);
    for (const toml::node& element : *array)
        readSection(element, key, section);
}

void TableReader::reportUnknown() {
    if (_ignoreRest)
        return;
    const std::vector<std::string> known(_requestedKeys.begin(), _requestedKeys.end());
    for (const auto& [key, node] : _table) {
        const std::string name(key.str());
        if (_requestedKeys.count(name))
            continue;
        const std::string similar = nearestName(name, known);
        _log.add(
            osgTreeWind::problemAt(key.source(), _log, dotted(printable(name)),
                                   "unknown key; " + (similar.empty() ? "known here: " + joined(known)
                                                                      : "did you mean " + similar + '?')));
    }
}

} // namespace osgTreeWind
