// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanRows.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>

#include <algorithm>

namespace osgTreeWind {

bool ScanRows::next() {
    constexpr std::string_view separators = " \t\r\f,";
    _words.clear();
    while (_words.empty() && !_text.empty()) {
        ++_line;
        _row = _text.substr(0, _text.find('\n'));
        _text.remove_prefix(std::min(_row.size() + 1, _text.size()));
        std::size_t at = _row.find_first_not_of(separators);
        if (at != std::string_view::npos && _row[at] == '#')
            continue;
        while (at != std::string_view::npos) {
            const std::size_t end = std::min(_row.find_first_of(separators, at), _row.size());
            _words.push_back(_row.substr(at, end - at));
            at = _row.find_first_not_of(separators, end);
        }
    }
    return !_words.empty();
}

double ScanRows::number(std::size_t word, const ScanQuantity& quantity) {
    const auto value = parseNumber(_words[word]);
    if (value && quantity.range.contains(*value))
        return *value;
    fail(word, expectedFound(quantity.description, _words[word]));
    return 0.0;
}

int ScanRows::integer(std::size_t word, const char* description, int low, int high) {
    const double value = number(word, {description, within(low, high)});
    if (value != static_cast<int>(value))
        fail(word, expectedFound(description, _words[word]));
    return static_cast<int>(value);
}

void ScanRows::fail(std::size_t word, const std::string& message) {
    if (good())
        _problem = {_file, _line, static_cast<int>(_words[word].data() - _row.data()) + 1, {}, message};
}

void ScanRows::failLine(const std::string& message) {
    if (good())
        _problem = {_file, _line, 0, {}, message};
}

} // namespace osgTreeWind
