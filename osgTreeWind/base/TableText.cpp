// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TableText.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

/// The first non-blank line.
std::string_view findHeader(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \r\n"), text.size()));
    return text.substr(0, text.find_first_of("\r\n"));
}

char guessDelimiter(std::string_view text) {
    std::string unquoted;
    bool isQuoted = false;
    for (const char c : findHeader(text)) {
        isQuoted = isQuoted != (c == '"');
        if (!isQuoted)
            unquoted += c;
    }
    char best = ',';
    std::ptrdiff_t maxCount = 0;
    for (const char delimiter : {';', '\t', '|', ','})
        if (const auto count = std::count(unquoted.begin(), unquoted.end(), delimiter); count > maxCount) {
            best = delimiter;
            maxCount = count;
        }
    return best;
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
    const char found = guessDelimiter(plain.value());
    table.format.delimiter = options.delimiter.value_or(found);
    table.format.decimalComma = options.decimalComma.value_or(table.format.delimiter != ',');
    if (!options.delimiter && found != ',')
        table.notes.push_back("its cells are separated by " + (found == '\t' ? "tabs" : inQuotes({found})) +
                              (options.decimalComma ? "" : ", and its numbers may have decimal commas"));
    const std::size_t markSize = decoded.text.size() - plain.value().size();
    table.text = std::move(decoded.text);
    table.text.erase(0, markSize);
    return table;
}

} // namespace osgTreeWind
