// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TableText.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/NameMatching.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/base/TableLayout.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

/// The delimiter that a first line "sep=;" states.
std::optional<char> statedDelimiter(std::string_view text) {
    constexpr std::string_view word = "sep=";
    text.remove_prefix(!text.empty() && text.front() == '"' ? 1 : 0);
    if (text.substr(0, word.size()) != word || text.size() == word.size())
        return std::nullopt;
    return text[word.size()];
}

std::string delimiterName(char delimiter) {
    return delimiter == '\t' ? "tabs" : delimiter == ' ' ? "blanks" : inQuotes({delimiter});
}

constexpr const char* hint =
    "; to read it otherwise, set header_line (0: no header), comment (how lines begin that are left out) or "
    "delimiter in [inventory], or in a [wind] of kind \"series\"";

/// The problem that a table has no column that is asked for.
std::optional<Diagnostic> missingColumns(const TableLayout& layout, const std::vector<std::string>& columns,
                                         const std::string& file) {
    if (columns.empty() || layout.names.empty() || layout.foundCount > 0 ||
        !std::all_of(columns.begin(), columns.end(), mayBeColumn))
        return std::nullopt;
    std::string similar;
    for (auto name = columns.begin(); name != columns.end() && similar.empty(); ++name)
        similar = nearestName(*name, layout.names);
    return fileProblem(file,
                       "expected a header with " + alternatives(columns) + ", found " +
                           inQuotes(joined(layout.names)) +
                           (similar.empty() ? "" : "; did you mean " + inQuotes(similar) + '?') + hint,
                       layout.headerLine);
}

} // namespace

Result<TableText> decodeTable(std::string bytes, const std::string& file, const TableOptions& options) {
    DecodedText decoded = decodeText(std::move(bytes));
    const Result<std::string_view> plain = plainText(decoded.text, file);
    if (!plain)
        return plain.problems();
    TableText table;
    if (!decoded.assumed.empty())
        table.notes.push_back("is no UTF-8 and is read as " + decoded.assumed);
    TableOptions stated = options;
    if (!stated.delimiter)
        stated.delimiter = statedDelimiter(plain.value());
    TableLayout layout = findTable(plain.value(), stated);
    if (auto problem = missingColumns(layout, options.columns, file))
        return std::move(*problem);
    const char found = layout.format.delimiter;
    if (!stated.delimiter && found != ',')
        table.notes.push_back("its cells are separated by " + delimiterName(found) +
                              (options.decimalComma ? "" : ", and its numbers may have decimal commas"));
    table.notes.insert(table.notes.end(), layout.notes.begin(), layout.notes.end());
    table.format = std::move(layout.format);
    if (!options.columns.empty())
        table.format.hint = hint;
    if (found == ' ') {
        table.format.delimiter = '\t';
        table.text = blanksToTabs(plain.value());
        return table;
    }
    const std::size_t markSize = decoded.text.size() - plain.value().size();
    table.text = std::move(decoded.text);
    table.text.erase(0, markSize);
    return table;
}

} // namespace osgTreeWind
