// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TextTokens.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>

namespace osgTreeWind {

namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

} // namespace

std::string_view TextTokens::next() {
    for (; _at < _text.size() && isBlank(_text[_at]); ++_at)
        if (_text[_at] == '\n')
            ++_line;
    _begin = _at;
    while (_at < _text.size() && !isBlank(_text[_at]))
        ++_at;
    return _text.substr(_begin, _at - _begin);
}

std::string_view TextTokens::restOfLine() {
    const std::size_t begin = _at;
    while (_at < _text.size() && _text[_at] != '\n')
        ++_at;
    std::string_view rest = _text.substr(begin, _at - begin);
    if (_at < _text.size()) {
        ++_at;
        ++_line;
    }
    _begin = _at;
    if (!rest.empty() && rest.back() == '\r')
        rest.remove_suffix(1);
    return rest;
}

std::string_view TextTokens::bytes(std::size_t count) {
    const std::string_view taken = _text.substr(_at, count);
    _at += taken.size();
    return taken;
}

double TextTokens::number(const char* what, double low, double high) {
    const std::string_view word = next();
    const auto value = parseNumber(word);
    if (value && *value >= low && *value <= high)
        return *value;
    fail(expectedFound(what, word));
    return 0.0;
}

int TextTokens::integer(const char* what, int low, int high) {
    const std::string_view word = next();
    const auto value = parseNumber(word);
    if (value && *value >= low && *value <= high && *value == static_cast<int>(*value))
        return static_cast<int>(*value);
    fail(expectedFound(what, word));
    return 0;
}

void TextTokens::fail(const std::string& message) {
    if (good())
        _problem = {_file, _line, 0, {}, message};
}

} // namespace osgTreeWind
