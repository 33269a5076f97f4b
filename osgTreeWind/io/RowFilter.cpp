// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/RowFilter.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/io/TreeRows.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace osgTreeWind {
namespace {

using Condition = RowFilter::Condition;
using Truth = std::optional<bool>; // empty: unknown

/// A cell or a literal: a text, and its number if it is one.
struct Value {
    std::string text;
    std::optional<double> number;
};
using Operand = std::function<std::optional<Value>(const TreeRows& row)>; // empty: NULL

/// -1, 0 or 1. Compares numbers if both values are numbers, and texts otherwise.
int compareValues(const Value& a, const Value& b) {
    if (a.number && b.number)
        return *a.number < *b.number ? -1 : *a.number > *b.number;
    const int order = a.text.compare(b.text);
    return order < 0 ? -1 : order > 0;
}

/// Matches a pattern of SQL's LIKE: % stands for any text, _ for one byte.
bool isLike(const std::string& text, const std::string& pattern) {
    std::size_t t = 0, p = 0, star = std::string::npos, from = 0;
    while (t < text.size())
        if (p < pattern.size() && pattern[p] == '%') {
            star = p++;
            from = t;
        } else if (p < pattern.size() && (pattern[p] == '_' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != std::string::npos) {
            p = star + 1;
            t = ++from;
        } else
            return false;
    return pattern.find_first_not_of('%', p) == std::string::npos;
}

Truth logicalAnd(const Truth& a, const Truth& b) {
    if (a == Truth(false) || b == Truth(false))
        return false;
    return a && b ? Truth(true) : std::nullopt;
}

Truth logicalNot(const Truth& a) {
    return a ? Truth(!*a) : a;
}

Truth logicalOr(const Truth& a, const Truth& b) {
    return logicalNot(logicalAnd(logicalNot(a), logicalNot(b)));
}

struct Token {
    enum Kind { End, Name, Text, Number, Sign } kind = End;
    std::string text;
    std::size_t at = 0;
    bool isQuoted = false; ///< A quoted name is not a keyword.
};

struct SyntaxError {
    std::size_t at;
    std::string message;
};

/// A recursive-descent parser.
class Parser {
public:
    Parser(const std::string& text, const TreeRows& rows) : _text(text), _rows(rows) { advance(); }

    Condition parseAll() {
        Condition condition = parseOr();
        if (_token.kind != Token::End)
            fail("AND, OR or the end");
        return condition;
    }
    std::vector<std::size_t> columns;

private:
    [[noreturn]] void fail(const std::string& expected) const {
        throw SyntaxError{_token.at, expectedFound(expected, _token.text)};
    }

    static bool isNamePart(char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 ||
               c == '_' || c == '.' || c == ':' || c == '@';
    }

    void advance() {
        _at = std::min(_text.find_first_not_of(" \t\r\n", _at), _text.size());
        _token = {Token::End, "", _at, false};
        if (_at == _text.size())
            return;
        const char first = _text[_at];
        if (first == '\'' || first == '"')
            return readQuoted(first);
        std::size_t end = _at;
        if (isNamePart(first) ||
            ((first == '-' || first == '+') && _at + 1 < _text.size() && isNamePart(_text[_at + 1]))) {
            for (++end; end < _text.size() && (isNamePart(_text[end]) || isExponentSign(end)); ++end)
                ;
            _token.text = _text.substr(_at, end - _at);
            _token.kind = parseNumber(_token.text) ? Token::Number : Token::Name;
        } else {
            const std::string two = _text.substr(_at, 2);
            end += two == "<=" || two == ">=" || two == "<>" || two == "!=" ? 2 : 1;
            _token.text = _text.substr(_at, end - _at);
            _token.kind = Token::Sign;
        }
        _at = end;
    }

    /// Whether the character is the sign in a number such as 1e-3.
    bool isExponentSign(std::size_t at) const {
        const char first = _text[_token.at];
        const bool isSigned = first == '-' || first == '+';
        return (_text[at] == '-' || _text[at] == '+') && lower(_text.substr(at - 1, 1)) == "e" &&
               std::isdigit(static_cast<unsigned char>(isSigned ? _text[_token.at + 1] : first));
    }

    void readQuoted(char quote) {
        _token.kind = quote == '"' ? Token::Name : Token::Text;
        _token.isQuoted = true;
        for (++_at; _at < _text.size(); ++_at) {
            if (_text[_at] == quote && (_at + 1 == _text.size() || _text[_at + 1] != quote)) {
                ++_at;
                return;
            }
            _token.text += _text[_at];
            _at += _text[_at] == quote; // a doubled quote
        }
        throw SyntaxError{_token.at, std::string("expected a ") + quote + " at its end"};
    }

    bool isKeyword(const char* word) const {
        return _token.kind == Token::Name && !_token.isQuoted && lower(_token.text) == word;
    }
    bool accept(const char* wordOrSign) {
        const bool isIt = isKeyword(wordOrSign) || (_token.kind == Token::Sign && _token.text == wordOrSign);
        if (isIt)
            advance();
        return isIt;
    }
    void require(const char* wordOrSign) {
        if (!accept(wordOrSign))
            fail(wordOrSign);
    }

    Condition parseOr() {
        Condition condition = parseAnd();
        while (accept("or"))
            condition = [a = std::move(condition), b = parseAnd()](const TreeRows& row) {
                return logicalOr(a(row), b(row));
            };
        return condition;
    }

    Condition parseAnd() {
        Condition condition = parseNot();
        while (accept("and"))
            condition = [a = std::move(condition), b = parseNot()](const TreeRows& row) {
                return logicalAnd(a(row), b(row));
            };
        return condition;
    }

    Condition parseNot() {
        constexpr int maxDepth = 50;
        if (++_depth > maxDepth)
            fail("at most 50 brackets and NOT within each other");
        Condition condition;
        if (accept("not"))
            condition = [a = parseNot()](const TreeRows& row) { return logicalNot(a(row)); };
        else if (accept("(")) {
            condition = parseOr();
            require(")");
        } else
            condition = parseComparison();
        --_depth;
        return condition;
    }

    Condition parseComparison() {
        const Operand left = parseOperand();
        if (accept("is")) {
            const bool isNot = accept("not");
            require("null");
            return [left, isNot](const TreeRows& row) { return Truth(left(row).has_value() == isNot); };
        }
        const bool isNot = accept("not");
        Condition condition;
        if (accept("in"))
            condition = parseIn(left);
        else if (accept("like"))
            condition = parseLike(left);
        else if (accept("between")) {
            const Operand low = parseOperand();
            require("and");
            condition = [low = makeComparison(left, low, ">="),
                         high = makeComparison(left, parseOperand(), "<=")](const TreeRows& row) {
                return logicalAnd(low(row), high(row));
            };
        } else {
            const std::string sign = _token.text;
            for (const char* const known : {"=", "<>", "!=", "<", "<=", ">", ">="})
                if (!isNot && accept(known))
                    return makeComparison(left, parseOperand(), sign);
            fail(isNot ? "IN, LIKE or BETWEEN" : "=, <>, <, <=, >, >=, IN, LIKE, BETWEEN or IS NULL");
        }
        if (!isNot)
            return condition;
        return [condition](const TreeRows& row) { return logicalNot(condition(row)); };
    }

    static Condition makeComparison(const Operand& left, const Operand& right, const std::string& sign) {
        const bool differ = sign == "<>" || sign == "!=", less = differ || sign[0] == '<',
                   more = differ || sign[0] == '>', equal = !differ && sign.back() == '=';
        return [=](const TreeRows& row) -> Truth {
            const auto a = left(row), b = right(row);
            if (!a || !b)
                return std::nullopt;
            const int order = compareValues(*a, *b);
            return order < 0 ? less : order > 0 ? more : equal;
        };
    }

    Condition parseIn(const Operand& left) {
        require("(");
        Condition among = makeComparison(left, parseOperand(), "=");
        while (accept(","))
            among = [a = std::move(among), b = makeComparison(left, parseOperand(), "=")](
                        const TreeRows& row) { return logicalOr(a(row), b(row)); };
        require(")");
        return among;
    }

    Condition parseLike(const Operand& left) {
        if (_token.kind != Token::Text)
            fail("a text in '...'");
        const std::string pattern = lower(_token.text);
        advance();
        return [left, pattern](const TreeRows& row) -> Truth {
            const auto value = left(row);
            return value ? Truth(isLike(lower(value->text), pattern)) : std::nullopt;
        };
    }

    Operand parseOperand() {
        const Token token = _token;
        if (token.kind == Token::End || token.kind == Token::Sign)
            fail("a column, a number or a text in '...'");
        if (token.kind != Token::Name) {
            advance();
            return [value = Value{token.text, parseNumber(token.text)}](const TreeRows&) {
                return std::optional(value);
            };
        }
        const auto column = _rows.column(token.text);
        if (!column)
            throw SyntaxError{token.at, _rows.problemOfColumn(token.text)};
        advance();
        if (std::find(columns.begin(), columns.end(), *column) == columns.end())
            columns.push_back(*column);
        return [at = *column](const TreeRows& row) -> std::optional<Value> {
            if (!row.has(at))
                return std::nullopt;
            return Value{row.text(at), row.number(at)};
        };
    }

    const std::string& _text;
    const TreeRows& _rows;
    std::size_t _at = 0;
    int _depth = 0;
    Token _token;
};

} // namespace

Result<RowFilter> RowFilter::parse(const std::string& text, const TreeRows& rows) {
    try {
        Parser parser(text, rows);
        RowFilter filter;
        filter._condition = parser.parseAll();
        filter._columns = std::move(parser.columns);
        return filter;
    } catch (const SyntaxError& problem) {
        return Diagnostic{
            {}, 0, 0, {}, "at character " + std::to_string(problem.at + 1) + ": " + problem.message};
    }
}

} // namespace osgTreeWind
