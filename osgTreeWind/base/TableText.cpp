// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TableText.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

/// The first line that is not blank.
std::string_view headerOf(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \r\n"), text.size()));
    return text.substr(0, text.find_first_of("\r\n"));
}

char delimiterOf(std::string_view text) {
    std::string bare;
    bool isQuoted = false;
    for (const char c : headerOf(text)) {
        isQuoted = isQuoted != (c == '"');
        if (!isQuoted)
            bare += c;
    }
    char best = ',';
    std::ptrdiff_t most = 0;
    for (const char delimiter : {';', '\t', '|', ','})
        if (const auto count = std::count(bare.begin(), bare.end(), delimiter); count > most) {
            best = delimiter;
            most = count;
        }
    return best;
}

} // namespace

Result<TableText> tableText(std::string bytes, const std::string& file, const TableOptions& options) {
    DecodedText decoded = decodeText(std::move(bytes));
    const Result<std::string_view> plain = plainText(decoded.text, file);
    if (!plain)
        return plain.problems();
    TableText table;
    if (!decoded.assumed.empty())
        table.notes.push_back("is no UTF-8 and is read as " + decoded.assumed);
    const char found = delimiterOf(plain.value());
    table.format.delimiter = options.delimiter.value_or(found);
    table.format.decimalComma = options.decimalComma.value_or(table.format.delimiter != ',');
    if (!options.delimiter && found != ',')
        table.notes.push_back("its cells are parted by " + (found == '\t' ? "tabs" : inQuotes({found})) +
                              (options.decimalComma ? "" : ", and its numbers may have decimal commas"));
    const std::size_t mark = decoded.text.size() - plain.value().size();
    table.text = std::move(decoded.text);
    table.text.erase(0, mark);
    return table;
}

} // namespace osgTreeWind
