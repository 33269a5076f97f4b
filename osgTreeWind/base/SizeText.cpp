// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/SizeText.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr std::string_view digits = "0123456789";

/// A text and the tokens that it stands for.
struct Synonym {
    std::string_view text, tokens;
};

/// Symbols in UTF-8.
constexpr Synonym symbols[] = {
    {"′", "'"},   {"’", "'"},   {"‘", "'"},   {"´", "'"},      {"″", "\""},    {"”", "\""}, {"“", "\""},
    {"''", "\""}, {"–", "-"},   {"—", "-"},   {"−", "-"},      {"‐", "-"},     {"‑", "-"},  {"×", "x"},
    {"*", "x"},   {"≥", ">"},   {"≤", "<"},   {"≈", "~"},      {"±", "~"},     {"?", "~"},  {";", "+"},
    {"½", ".5"},  {"¼", ".25"}, {"¾", ".75"}, {"\u00a0", " "}, {"\u202f", " "}};

/// Words, of which 't' means "to" and 'b' means "between".
constexpr Synonym words[] = {{"about", "~"},    {"approx", "~"},    {"approximately", "~"},
                             {"around", "~"},   {"c", "~"},         {"ca", "~"},
                             {"circa", "~"},    {"env", "~"},       {"environ", "~"},
                             {"est", "~"},      {"estimated", "~"}, {"etwa", "~"},
                             {"ongeveer", "~"}, {"rund", "~"},      {"over", ">"},
                             {"above", ">"},    {"more", ">"},      {"greater", ">"},
                             {"higher", ">"},   {"larger", ">"},    {"mehr", ">"},
                             {"meer", ">"},     {"hoger", ">"},     {"plus", ">"},
                             {"ab", ">"},       {"vanaf", ">"},     {"über", ">"},
                             {"under", "<"},    {"below", "<"},     {"less", "<"},
                             {"smaller", "<"},  {"lower", "<"},     {"unter", "<"},
                             {"weniger", "<"},  {"minder", "<"},    {"lager", "<"},
                             {"moins", "<"},    {"onder", "<"},     {"up", "<"},
                             {"to", "t"},       {"bis", "t"},       {"tot", "t"},
                             {"à", "t"},        {"a", "t"},         {"between", "b"},
                             {"zwischen", "b"}, {"entre", "b"},     {"tussen", "b"},
                             {"and", "&"},      {"und", "&"},       {"en", "&"},
                             {"et", "&"},       {"or", "&"},        {"oder", "&"},
                             {"ou", "&"},       {"of", "&"},        {"than", ""},
                             {"als", ""},       {"dan", ""},        {"de", ""},
                             {"from", ""},      {"von", ""},        {"van", ""},
                             {"zu", ""},        {"x", "x"}};

/// A number ('0'), a unit ('u', in metres), or a sign.
struct Token {
    char kind;
    double value = 0.0;
};

double footSize() {
    static const double metres = *knownUnit(Dimension::Length, "ft");
    return metres;
}

double inchSize() {
    static const double metres = *knownUnit(Dimension::Length, "in");
    return metres;
}

/// The number, or the numbers between commas, at the beginning of a text.
std::string_view figuresOf(std::string_view text) {
    text = text.substr(0, text.find_first_not_of("0123456789.,"));
    if (!text.empty() && text[0] == ',')
        return {};
    return text.substr(0, text.find_last_of(digits) + 1);
}

/// Whether the only comma in some figures may be decimal.
bool mayBeDecimal(std::string_view figures) {
    return std::count(figures.begin(), figures.end(), ',') == 1 && figures.find('.') == figures.npos;
}

/// Splits a text into tokens. @return empty if something in it is unknown.
class SizeTokens {
public:
    SizeTokens(std::string_view text, bool commaSeparates)
        : _text(lower(std::string(text))), _commaSeparates(commaSeparates) {
        for (const Synonym& symbol : symbols)
            for (std::size_t at = 0; (at = _text.find(symbol.text, at)) != std::string::npos;)
                _text.replace(at, symbol.text.size(), symbol.tokens);
    }

    std::vector<Token> read() {
        constexpr std::string_view blanks = " \t()[]=";
        while ((_at = std::min(_text.find_first_not_of(blanks, _at), _text.size())) < _text.size())
            if (!readNumbers() && !readWord() && !readSign())
                return {};
        return _tokens;
    }

private:
    /// Reads a number, or several between commas.
    bool readNumbers() {
        std::string figures(figuresOf(std::string_view(_text).substr(_at)));
        _at += figures.size();
        if (mayBeDecimal(figures) && !_commaSeparates)
            std::replace(figures.begin(), figures.end(), ',', '.');
        for (std::size_t start = 0, end = 0; start < figures.size(); start = end + 1) {
            end = std::min(figures.find(',', start), figures.size());
            const auto number = parseNumber(std::string_view(figures).substr(start, end - start));
            if (!number)
                return false;
            if (start > 0)
                _tokens.push_back({','});
            _tokens.push_back({'0', *number});
        }
        return !figures.empty();
    }
    bool readWord() {
        std::size_t end = _at;
        while (end < _text.size() &&
               ((_text[end] >= 'a' && _text[end] <= 'z') || static_cast<unsigned char>(_text[end]) >= 0x80))
            ++end;
        const std::string_view word = std::string_view(_text).substr(_at, end - _at);
        const auto known = std::find_if(std::begin(words), std::end(words),
                                        [&](const Synonym& synonym) { return synonym.text == word; });
        const auto unit = knownUnit(Dimension::Length, std::string(word));
        if (unit)
            _tokens.push_back({'u', *unit});
        else if (known == std::end(words))
            return false;
        else
            for (const char token : known->tokens)
                _tokens.push_back({token});
        _at = end < _text.size() && _text[end] == '.' ? end + 1 : end; // "ca."
        return true;
    }
    bool readSign() {
        const char sign = _text[_at++];
        if (sign == '\'' || sign == '"')
            _tokens.push_back({'u', sign == '"' ? inchSize() : footSize()});
        else
            _tokens.push_back({sign});
        return std::string_view("'\"~<>-+,/&").find(sign) != std::string_view::npos;
    }

    std::string _text;
    bool _commaSeparates;
    std::size_t _at = 0;
    std::vector<Token> _tokens{};
};

/// Reads a size from its tokens.
class SizeReader {
public:
    SizeReader(std::vector<Token> tokens, SizeKind kind) : _tokens(std::move(tokens)), _kind(kind) {}

    std::optional<SizeText> read() {
        readSigns();
        if (!readLengths())
            return std::nullopt;
        const auto unit = unitOfAll();
        std::vector<double> sizes;
        for (const Length& length : _lengths)
            sizes.push_back(length.value * length.unit.value_or(unit.value_or(1.0)));
        const auto value = combined(sizes);
        if (!value)
            return std::nullopt;
        return SizeText{*value, unit.has_value(), _isEstimate || (_joint == '-' && sizes.size() > 1)};
    }

private:
    struct Length {
        double value;
        std::optional<double> unit; ///< Metres.
    };

    char kindAt(std::size_t index) const { return index < _tokens.size() ? _tokens[index].kind : '\0'; }
    bool isBound(std::size_t index) const { return kindAt(index) == '<' || kindAt(index) == '>'; }

    /// Takes "about" and bounds out of the tokens: ">9 <12" becomes "9-12", and "18 and more" becomes "18".
    void readSigns() {
        std::vector<Token> rest;
        bool hasLow = false, hasHigh = false, isBetween = false;
        for (std::size_t i = 0; i < _tokens.size(); ++i) {
            char kind = kindAt(i);
            const bool isLast = i + 1 == _tokens.size(), isFirst = rest.empty();
            isBetween |= kind == 'b';
            hasLow |= kind == '>' || (kind == '+' && isLast);
            hasHigh |= kind == '<' || (kind == 't' && isFirst);
            _isEstimate |= kind == '~' || hasLow || hasHigh;
            if (isBound(i) || kind == '~' || kind == 'b' || (kind == '+' && isLast) ||
                (kind == 't' && isFirst) || (kind == '&' && isBound(i + 1)))
                continue;
            if (kind == 't' || (kind == '&' && isBetween))
                kind = '-';
            if (kind == '0' && !isFirst && rest.back().kind != 'x' && hasLow && hasHigh && rest.size() <= 2 &&
                rest.back().kind != '-')
                rest.push_back({'-'});
            rest.push_back({kind == '&' ? '+' : kind, _tokens[i].value});
        }
        _tokens = rest;
    }

    bool readLengths() {
        while (readLength()) {
            if (_at == _tokens.size())
                return true;
            const char mark = kindAt(_at++), joint = mark == ',' ? '+' : mark;
            if ((_joint && joint != _joint) || joint == 'u' || joint == '0')
                return false;
            _joint = joint;
        }
        return false;
    }
    bool readLength() {
        const std::size_t count = readCount();
        if (kindAt(_at) != '0')
            return false;
        Length length{_tokens[_at++].value, {}};
        if (kindAt(_at) == 'u')
            length.unit = _tokens[_at++].value;
        if (length.unit == footSize() && kindAt(_at) == '0' && kindAt(_at + 1) != 'x') {
            const bool isInch = kindAt(_at + 1) != 'u' || _tokens[_at + 1].value == inchSize();
            if (isInch) {
                length.value += _tokens[_at++].value / 12.0;
                _at += kindAt(_at) == 'u';
            }
        }
        _lengths.insert(_lengths.end(), count, length);
        if (count > 1 && !_joint)
            _joint = '+';
        return true;
    }
    /// Reads the number of stems in "3x10".
    std::size_t readCount() {
        constexpr double maxStems = 20.0;
        const double count = kindAt(_at) == '0' ? _tokens[_at].value : 0.0;
        if (_kind != SizeKind::Trunk || kindAt(_at + 1) != 'x' || count < 1.0 || count > maxStems ||
            count != std::floor(count))
            return 1;
        _at += 2;
        return static_cast<std::size_t>(count);
    }

    /// The unit of numbers without one: that at the end, or else at the beginning, as in "9-12 m".
    std::optional<double> unitOfAll() const {
        return _lengths.back().unit ? _lengths.back().unit : _lengths.front().unit;
    }

    std::optional<double> combined(const std::vector<double>& sizes) {
        const bool isPair = sizes.size() == 2, isTrunk = _kind == SizeKind::Trunk;
        if (_joint == '/')
            _joint = !isTrunk ? '-' : isPair ? '/' : '+'; // "16/18" is a class in nurseries, or two stems
        if (sizes.size() == 1)
            return sizes[0];
        if (isPair && ((_joint == '-' && sizes[0] < sizes[1]) || (_joint == 'x' && _kind == SizeKind::Width)))
            return 0.5 * (sizes[0] + sizes[1]);
        if (!isTrunk || _joint != '+')
            return std::nullopt;
        double squares = 0.0;
        for (const double size : sizes)
            squares += size * size;
        return std::sqrt(squares);
    }

    std::vector<Token> _tokens;
    const SizeKind _kind;
    std::size_t _at = 0;
    std::vector<Length> _lengths{};
    char _joint = '\0';
    bool _isEstimate = false;
};

/// "5-10 m" of "B (5-10 m)", a class with its letter; otherwise the text.
std::string_view withoutLetter(std::string_view text) {
    text = trimmed(text);
    const std::size_t bracket = text.find('(');
    if (bracket == text.npos || text.back() != ')' || text.find_first_of(digits) < bracket)
        return text;
    const std::string letter = lower(std::string(trimmed(text.substr(0, bracket))));
    const bool isLetter = letter.size() == 1 && letter[0] >= 'a' && letter[0] <= 'z';
    return isLetter ? text.substr(bracket) : text;
}

} // namespace

std::optional<SizeText> parseSize(std::string_view text, SizeKind kind, bool commaSeparates) {
    if (const auto number = parseNumber(text))
        return SizeText{*number};
    constexpr std::size_t maxLength = 60;
    if (text.size() > maxLength)
        return std::nullopt;
    return SizeReader(SizeTokens(withoutLetter(text), commaSeparates && kind == SizeKind::Trunk).read(), kind)
        .read();
}

std::optional<bool> commaSeparatesNumbers(std::string_view text) {
    for (std::size_t at = 0; (at = text.find_first_of(digits, at)) != text.npos;) {
        const std::string_view figures = figuresOf(text.substr(at));
        const std::size_t comma = figures.find(',');
        at += figures.size();
        if (comma == figures.npos)
            continue;
        if (!mayBeDecimal(figures))
            return true;
        if (figures.substr(0, comma) == "0" || figures[comma + 1] == '0')
            return false;
    }
    return std::nullopt;
}

} // namespace osgTreeWind
