// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/SqlText.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/NameMatching.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/base/Text.h>

#include <sqlite3.h>

#include <algorithm>
#include <cctype>

namespace osgTreeWind {

namespace {

constexpr int maxDepth = 50, maxCalls = 200;
constexpr std::string_view blanks = " \t\r\n", arithmeticSigns = "+-*/%";

const std::vector<std::string> sqlFunctions = {
    "abs",     "acos", "asin",   "atan",      "atan2",   "ceil",    "ceiling", "coalesce", "cos",
    "degrees", "exp",  "floor",  "glob",      "ifnull",  "iif",     "instr",   "length",   "like",
    "ln",      "log",  "log10",  "log2",      "lower",   "ltrim",   "max",     "min",      "mod",
    "nullif",  "pi",   "pow",    "power",     "radians", "replace", "round",   "rtrim",    "sign",
    "sin",     "sqrt", "substr", "substring", "tan",     "trim",    "trunc",   "typeof",   "upper"};

/// Words of SQL that an expression may contain. A column with such a name needs double quotes.
const std::vector<std::string> sqlWords = {
    "and",  "or",   "not",  "in",   "like", "glob", "between", "is",     "null", "isnull",  "notnull",
    "case", "when", "then", "else", "end",  "cast", "as",      "escape", "from", "collate", "distinct"};

/// What may follow AS and COLLATE.
const std::vector<std::string> sqlTypes = {"integer", "numeric", "real", "text"},
                               sqlOrders = {"binary", "nocase", "rtrim"};

bool isAmong(const std::string& word, const std::vector<std::string>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool isNamePart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 || c == '_' ||
           c == '.' || c == ':' || c == '@';
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// End of the name or number that begins at `at`.
std::size_t endOfWord(const std::string& text, std::size_t at) {
    const bool isNumber = isDigit(text[at]) || text[at] == '.';
    std::size_t end = at + 1;
    const auto isExponentSign = [&] {
        return isNumber && (text[end] == '-' || text[end] == '+') && (text[end - 1] | 0x20) == 'e' &&
               end + 1 < text.size() && isDigit(text[end + 1]) &&
               parseNumber(std::string_view(text).substr(at, end - 1 - at));
    };
    while (end < text.size() && (isNamePart(text[end]) || isExponentSign()))
        ++end;
    return end;
}

} // namespace

std::string sqlCell(std::size_t index) {
    return 'c' + std::to_string(index);
}

std::string sqlNumber(std::size_t index) {
    return 'n' + std::to_string(index);
}

bool isSqlFunction(const std::string& name) {
    return isAmong(lower(name), sqlFunctions);
}

SqlText::SqlText(const std::string& text, const std::vector<std::string>& columns, const std::string& file)
    : _text(text), _names(columns), _file(file) {
    if (text.size() > maxSqlLength) {
        fail(0, "expected at most " + std::to_string(maxSqlLength) + " bytes, found " +
                    std::to_string(text.size()));
        return;
    }
    for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) < text.size() && !_problem;) {
        _sql += ' ';
        _positions.emplace_back(_sql.size(), at);
        at = text[at] == '\'' || text[at] == '"' ? readQuoted(at)
             : isNamePart(text[at])              ? readWord(at)
                                                 : readSign(at);
    }
    if (!_problem && _depth > 0)
        fail(text.size(), expectedFound(")", ""));
    _positions.emplace_back(_sql.size(), text.size());
    _sql += " ) FROM cells";
    _isColumn = _positions.size() == 2 && _used.size() == 1;
}

std::size_t SqlText::fail(std::size_t at, std::string message) {
    if (!_problem)
        _problem = Problem{at, std::move(message)};
    return _text.size();
}

std::size_t SqlText::positionOf(std::size_t sqlPosition) const {
    const auto after =
        std::upper_bound(_positions.begin(), _positions.end(), sqlPosition,
                         [](std::size_t at, const auto& position) { return at < position.first; });
    return after == _positions.begin() ? 0 : (after - 1)->second;
}

std::string SqlText::wordAt(std::size_t at) const {
    if (at >= _text.size())
        return {};
    return _text.substr(at, isNamePart(_text[at]) ? endOfWord(_text, at) - at : 1);
}

char SqlText::signAfter(std::size_t at) const {
    at = _text.find_first_not_of(blanks, at);
    return at < _text.size() ? _text[at] : '\0';
}

std::size_t SqlText::readQuoted(std::size_t at) {
    const char quote = _text[at];
    std::string content;
    std::size_t end = at + 1;
    for (; end < _text.size(); ++end) {
        if (_text[end] == quote && (end + 1 == _text.size() || _text[end + 1] != quote))
            break;
        end += _text[end] == quote; // a doubled quote
        content += _text[end];
    }
    if (end >= _text.size())
        return fail(at, std::string("expected a ") + quote + " at its end");
    ++end;
    if (quote == '"')
        useName(content, at, end);
    else
        _sql.append(_text, at, end - at);
    _lastWord = quote;
    _lastSign = 0;
    return end;
}

std::size_t SqlText::readWord(std::size_t at) {
    const std::size_t end = endOfWord(_text, at);
    const std::string name = _text.substr(at, end - at), word = lower(name);
    const bool isCall = signAfter(end) == '(';
    if (isAmong(word, sqlWords) || (_lastWord == "as" && isAmong(word, sqlTypes)) ||
        (_lastWord == "collate" && isAmong(word, sqlOrders)) ||
        ((isDigit(name[0]) || name[0] == '.') && parseNumber(name)))
        _sql += name;
    else if (isCall && isAmong(word, sqlFunctions)) {
        _sql += name;
        if (++_calls > maxCalls)
            return fail(at, "expected at most " + std::to_string(maxCalls) + " calls of functions");
    } else if (isCall) {
        const std::string similar = nearestName(word, sqlFunctions);
        return fail(at, "no function " + inQuotes(name) +
                            (similar.empty() ? "" : "; did you mean " + inQuotes(similar) + '?'));
    } else
        useName(name, at, end);
    _lastWord = word;
    _lastSign = 0;
    return end;
}

void SqlText::useName(const std::string& name, std::size_t at, std::size_t end) {
    const auto column = std::find(_names.begin(), _names.end(), name);
    if (column != _names.end())
        useColumn(static_cast<std::size_t>(column - _names.begin()), end);
    else if (_text[at] != '"' && sqlite3_keyword_check(name.c_str(), static_cast<int>(name.size())))
        fail(at, expectedFound("an expression of SQL", name));
    else
        fail(at, problemOfColumn(name, _names, _file));
}

void SqlText::useColumn(std::size_t column, std::size_t end) {
    const auto used = std::find(_used.begin(), _used.end(), column);
    const auto index = static_cast<std::size_t>(used - _used.begin());
    if (used == _used.end())
        _used.push_back(column);
    const auto isArithmetic = [](char sign) {
        return sign != '\0' && arithmeticSigns.find(sign) != std::string_view::npos;
    };
    _sql += isArithmetic(_lastSign) || isArithmetic(signAfter(end)) ? sqlNumber(index) : sqlCell(index);
}

std::size_t SqlText::readSign(std::size_t at) {
    const char sign = _text[at];
    const std::string two = _text.substr(at, 2);
    if (two == "--" || two == "/*")
        return fail(at, expectedFound("no comment", two));
    if (std::string_view("+-*/%(),=<>!|&~").find(sign) == std::string_view::npos)
        return fail(at, expectedFound("an expression of SQL", std::string(1, sign)));
    _depth += sign == '(' ? 1 : sign == ')' ? -1 : 0;
    if (_depth < 0)
        return fail(at, expectedFound("the end", ")"));
    if (_depth > maxDepth)
        return fail(at, "expected at most " + std::to_string(maxDepth) + " brackets within each other");
    const bool isPair = two == "<=" || two == ">=" || two == "<>" || two == "!=" || two == "||" ||
                        two == "==" || two == "<<" || two == ">>";
    _sql += isPair ? two : sign == '/' ? "* 1.0 /" : std::string(1, sign);
    _lastWord.clear();
    _lastSign = sign;
    return at + (isPair ? 2 : 1);
}

} // namespace osgTreeWind
