// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TomlEdit.h>

#include <osgTreeWind/io/Toml.h>

#include <algorithm>
#include <optional>
#include <regex>

namespace osgTreeWind {

namespace {

/// The table of that name, or the root table for an empty name. May be null.
const toml::table* findTable(const Result<toml::table>& document, const std::string& name) {
    if (!document)
        return nullptr;
    return name.empty() ? &document.value() : document.value()[name].as_table();
}

/// The line after which a new key of a table can be inserted; empty for an inline table.
std::optional<std::size_t> findLastLine(const toml::table& table, bool isDocument) {
    if (table.is_inline())
        return std::nullopt;
    std::size_t last = isDocument ? 0 : table.source().begin.line;
    for (const auto& [key, node] : table) {
        const bool isSection =
            (node.is_table() && !node.as_table()->is_inline()) || node.is_array_of_tables();
        if (!isSection)
            last = std::max<std::size_t>(last, node.source().end.line);
    }
    return last;
}

} // namespace

void TomlEdit::append(const std::string& lines) {
    if (!_text.empty() && _text.back() != '\n')
        _text += '\n';
    _text += lines;
}

void TomlEdit::set(const std::string& table, const std::string& key, const std::string& value) {
    const Result<toml::table> document = parseToml(_text);
    const toml::table* const found = findTable(document, table);
    const std::string line = key + " = " + value + '\n';
    if (!found)
        return append("\n[" + table + "]\n" + line);
    if (const toml::node* node = found->get(key)) {
        const std::size_t begin = offsetOf(_text, node->source().begin);
        _text.replace(begin, offsetOf(_text, node->source().end) - begin, value);
    } else if (const auto last = findLastLine(*found, table.empty())) {
        const std::size_t at = lineBegin(_text, *last + 1);
        if (at == _text.size())
            append(line);
        else
            _text.insert(at, line);
    }
}

void TomlEdit::remove(const std::string& table, const std::string& key) {
    const Result<toml::table> document = parseToml(_text);
    const toml::table* const found = findTable(document, table);
    const toml::node* const node = found && !found->is_inline() ? found->get(key) : nullptr;
    if (!node)
        return;
    const std::size_t begin = lineBegin(_text, node->source().begin.line);
    _text.erase(begin, lineBegin(_text, node->source().end.line + 1) - begin);
}

void TomlEdit::replaceTables(const std::string& table, const std::string& lines) {
    const std::regex header(R"(^\s*\[\[?\s*([A-Za-z0-9_.-]+))"), content(R"(^\s*[^#\s])");
    const std::string parent = table.substr(0, table.find('.'));
    std::string kept, name, pending; // comments and empty lines, which belong to the next table
    std::optional<std::size_t> insertion, afterParent;
    for (std::size_t at = 0; at < _text.size();) {
        const std::size_t next = std::min(_text.find('\n', at), _text.size() - 1) + 1;
        const std::string line = _text.substr(at, next - at);
        at = next;
        std::smatch found;
        if (std::regex_search(line, found, header))
            name = found[1];
        const bool isReplaced = name == table || name.compare(0, table.size() + 1, table + '.') == 0;
        if (!std::regex_search(line, content)) {
            pending += line;
            continue;
        }
        if (isReplaced && !insertion)
            insertion = (kept += pending).size();
        else if (!isReplaced)
            kept += pending;
        pending.clear();
        if (!isReplaced)
            kept += line;
        if (name == parent)
            afterParent = kept.size();
    }
    _text = kept + pending;
    if (insertion)
        _text.insert(*insertion, lines);
    else if (afterParent)
        _text.insert(*afterParent, '\n' + lines);
    else
        append('\n' + lines);
}

} // namespace osgTreeWind
