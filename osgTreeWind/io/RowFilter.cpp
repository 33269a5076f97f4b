// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/RowFilter.h>

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

/// A cell or a literal: a text, and a number where it is one.
struct Value {
    std::string text;
    std::optional<double> number;
};
using Operand = std::function<std::optional<Value>(const TreeRows& row)>; // empty: NULL

/// -1, 0 or 1; as numbers where both are.
int compared(const Value& a, const Value& b) {
    if (a.number && b.number)
        return *a.number < *b.number ? -1 : *a.number > *b.number;
    const int order = a.text.compare(b.text);
    return order < 0 ? -1 : order > 0;
}

/// SQL's LIKE, whatever the case of letters: % stands for any text, _ for one byte.
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

Truth both(const Truth& a, const Truth& b) {
    if (a == Truth(false) || b == Truth(false))
        return false;
    return a && b ? Truth(true) : std::nullopt;
}

Truth opposite(const Truth& a) {
    return a ? Truth(!*a) : a;
}

Truth eitherOf(const Truth& a, const Truth& b) {
    return opposite(both(opposite(a), opposite(b)));
}

struct Token {
    enum Kind { End, Name, Text, Number, Sign } kind = End;
    std::string text;
    std::size_t at = 0;
    bool isQuoted = false; ///< A name, which is no keyword then.
};

/// Thrown where a condition is not understood.
struct NotUnderstood {
    std::size_t at;
    std::string message;
};

/// By recursive descent.
class Parser {
public:
    Parser(const std::string& text, const TreeRows& rows) : _text(text), _rows(rows) { advance(); }

    Condition all() {
        Condition condition = either();
        if (_token.kind != Token::End)
            fail("AND, OR or the end");
        return condition;
    }
    std::vector<std::size_t> columns;

private:
    [[noreturn]] void fail(const std::string& expected) const {
        throw NotUnderstood{_token.at, expectedFound(expected, _token.text)};
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
            return takeQuoted(first);
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

    /// Of 1e-3.
    bool isExponentSign(std::size_t at) const {
        const char first = _text[_token.at];
        const bool isSigned = first == '-' || first == '+';
        return (_text[at] == '-' || _text[at] == '+') && lower(_text.substr(at - 1, 1)) == "e" &&
               std::isdigit(static_cast<unsigned char>(isSigned ? _text[_token.at + 1] : first));
    }

    void takeQuoted(char quote) {
        _token.kind = quote == '"' ? Token::Name : Token::Text;
        _token.isQuoted = true;
        for (++_at; _at < _text.size(); ++_at) {
            if (_text[_at] == quote && (_at + 1 == _text.size() || _text[_at + 1] != quote)) {
                ++_at;
                return;
            }
            _token.text += _text[_at];
            _at += _text[_at] == quote; // doubled
        }
        throw NotUnderstood{_token.at, std::string("expected a ") + quote + " at its end"};
    }

    bool isWord(const char* word) const {
        return _token.kind == Token::Name && !_token.isQuoted && lower(_token.text) == word;
    }
    bool take(const char* wordOrSign) {
        const bool isIt = isWord(wordOrSign) || (_token.kind == Token::Sign && _token.text == wordOrSign);
        if (isIt)
            advance();
        return isIt;
    }
    void require(const char* wordOrSign) {
        if (!take(wordOrSign))
            fail(wordOrSign);
    }

    Condition either() {
        Condition condition = each();
        while (take("or"))
            condition = [a = std::move(condition), b = each()](const TreeRows& row) {
                return eitherOf(a(row), b(row));
            };
        return condition;
    }

    Condition each() {
        Condition condition = one();
        while (take("and"))
            condition = [a = std::move(condition), b = one()](const TreeRows& row) {
                return both(a(row), b(row));
            };
        return condition;
    }

    Condition one() {
        constexpr int deepest = 50;
        if (++_depth > deepest)
            fail("at most 50 brackets and NOT within each other");
        Condition condition;
        if (take("not"))
            condition = [a = one()](const TreeRows& row) { return opposite(a(row)); };
        else if (take("(")) {
            condition = either();
            require(")");
        } else
            condition = comparison();
        --_depth;
        return condition;
    }

    Condition comparison() {
        const Operand left = operand();
        if (take("is")) {
            const bool isNot = take("not");
            require("null");
            return [left, isNot](const TreeRows& row) { return Truth(left(row).has_value() == isNot); };
        }
        const bool isNot = take("not");
        Condition condition;
        if (take("in"))
            condition = amongOf(left);
        else if (take("like"))
            condition = likeOf(left);
        else if (take("between")) {
            const Operand low = operand();
            require("and");
            condition = [low = orderOf(left, low, ">="), high = orderOf(left, operand(), "<=")](
                            const TreeRows& row) { return both(low(row), high(row)); };
        } else {
            const std::string sign = _token.text;
            for (const char* const known : {"=", "<>", "!=", "<", "<=", ">", ">="})
                if (!isNot && take(known))
                    return orderOf(left, operand(), sign);
            fail(isNot ? "IN, LIKE or BETWEEN" : "=, <>, <, <=, >, >=, IN, LIKE, BETWEEN or IS NULL");
        }
        if (!isNot)
            return condition;
        return [condition](const TreeRows& row) { return opposite(condition(row)); };
    }

    static Condition orderOf(const Operand& left, const Operand& right, const std::string& sign) {
        const bool differ = sign == "<>" || sign == "!=", less = differ || sign[0] == '<',
                   more = differ || sign[0] == '>', equal = !differ && sign.back() == '=';
        return [=](const TreeRows& row) -> Truth {
            const auto a = left(row), b = right(row);
            if (!a || !b)
                return std::nullopt;
            const int order = compared(*a, *b);
            return order < 0 ? less : order > 0 ? more : equal;
        };
    }

    Condition amongOf(const Operand& left) {
        require("(");
        Condition among = orderOf(left, operand(), "=");
        while (take(","))
            among = [a = std::move(among), b = orderOf(left, operand(), "=")](const TreeRows& row) {
                return eitherOf(a(row), b(row));
            };
        require(")");
        return among;
    }

    Condition likeOf(const Operand& left) {
        if (_token.kind != Token::Text)
            fail("a text in '...'");
        const std::string pattern = lower(_token.text);
        advance();
        return [left, pattern](const TreeRows& row) -> Truth {
            const auto value = left(row);
            return value ? Truth(isLike(lower(value->text), pattern)) : std::nullopt;
        };
    }

    Operand operand() {
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
            throw NotUnderstood{token.at, _rows.problemOfColumn(token.text)};
        advance();
        if (std::find(columns.begin(), columns.end(), *column) == columns.end())
            columns.push_back(*column);
        return [at = *column](const TreeRows& row) -> std::optional<Value> {
            if (!row.has(at))
                return std::nullopt;
            const Result<double> number = row.number(at);
            return Value{row.text(at), number ? std::optional(number.value()) : std::nullopt};
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
        filter._condition = parser.all();
        filter._columns = std::move(parser.columns);
        return filter;
    } catch (const NotUnderstood& problem) {
        return Diagnostic{
            {}, 0, 0, {}, "at its character " + std::to_string(problem.at + 1) + ": " + problem.message};
    }
}

} // namespace osgTreeWind
