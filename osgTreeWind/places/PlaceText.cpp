// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/PlaceText.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr std::string_view digits = "0123456789", blanks = " \t", compassLetters = "nsew";

/// The text in lower case, with degrees, minutes and seconds marked by d ' and ".
std::string withPlainMarks(std::string_view text) {
    std::string plain = lower(std::string(text));
    const std::pair<const char*, const char*> marks[] = {
        {"degrees", "d"}, {"deg", "d"}, {"°", "d"},   {"º", "d"},      {"˚", "d"},
        {"′", "'"},       {"’", "'"},   {"‘", "'"},   {"´", "'"},      {"″", "\""},
        {"”", "\""},      {"“", "\""},  {"''", "\""}, {"\u00a0", " "}, {"−", "-"}};
    for (const auto& [mark, meaning] : marks)
        for (std::size_t at = 0; (at = plain.find(mark, at)) != std::string::npos;)
            plain.replace(at, std::string_view(mark).size(), meaning);
    return plain;
}

/// Reads a plain text from left to right.
class CoordinateReader {
public:
    explicit CoordinateReader(std::string_view text) : _text(text) {}

    std::optional<CoordinateText> read() {
        char letter = take(compassLetters);
        const char sign = take("+-");
        double size = 60.0; // of the current unit, in minutes
        int numbers = 0;
        for (; numbers < 3 && digits.find(peek()) != digits.npos && peek(); ++numbers, size /= 60.0) {
            const auto number = readNumber();
            const char mark = take(numbers == 0 ? "d:" : numbers == 1 ? "':" : "\"");
            if (!number || (numbers > 0 && *number > 60.0) || (_isLast && numbers > 0))
                return std::nullopt;
            _isLast = *number != std::floor(*number);
            _coordinate.value += *number * size / 60.0;
            _coordinate.isDegrees |= mark != 0 || numbers > 0;
        }
        if (!letter)
            letter = take(compassLetters);
        if (numbers == 0 || peek() || (letter && sign == '-'))
            return std::nullopt;
        if (letter) {
            _coordinate.axis = letter == 'e' || letter == 'w' ? 'x' : 'y';
            _coordinate.isDegrees = true;
        }
        const double most = _coordinate.axis == 'y' ? 90.0 : 360.0;
        if (_coordinate.isDegrees && _coordinate.value > most)
            return std::nullopt;
        if (sign == '-' || letter == 's' || letter == 'w')
            _coordinate.value = -_coordinate.value;
        return _coordinate;
    }

private:
    char peek() {
        _at = std::min(_text.find_first_not_of(blanks, _at), _text.size());
        return _at < _text.size() ? _text[_at] : '\0';
    }
    char take(std::string_view signs) {
        const char next = peek();
        const bool isSign = next && signs.find(next) != signs.npos;
        _at += isSign;
        return isSign ? next : '\0';
    }
    std::optional<double> readNumber() {
        const std::size_t end = std::min(_text.find_first_not_of("0123456789.,", _at), _text.size());
        std::string number(_text.substr(_at, end - _at));
        _at = end;
        std::replace(number.begin(), number.end(), ',', '.');
        return parseNumber(number);
    }

    std::string_view _text;
    std::size_t _at = 0;
    bool _isLast = false; ///< Whether the last number has decimals, so that no other follows.
    CoordinateText _coordinate{};
};

using Halves = std::pair<std::string_view, std::string_view>;

/// Splits before `at`, without a separator there.
Halves splitAt(std::string_view text, std::size_t at) {
    std::string_view first = text.substr(0, at), second = text.substr(at);
    first = first.substr(0, first.find_last_not_of(" \t,;|/") + 1);
    second.remove_prefix(std::min(second.find_first_not_of(" \t,;|/"), second.size()));
    return {first, second};
}

std::vector<std::size_t> positionsOf(std::string_view signs, std::string_view text) {
    std::vector<std::size_t> positions;
    for (std::size_t at = 0; (at = text.find_first_of(signs, at)) != text.npos; ++at)
        positions.push_back(at);
    return positions;
}

/// Splits a plain text into the texts of two coordinates.
std::optional<Halves> splitPair(std::string_view text) {
    if (const auto separators = positionsOf(";|/\t", text); separators.size() == 1)
        return splitAt(text, separators[0]);
    if (const auto letters = positionsOf(compassLetters, text); letters.size() == 2)
        return splitAt(text, letters[0] == 0 ? letters[1] : letters[0] + 1);
    const auto commas = positionsOf(",", text);
    if (commas.size() == 1 || commas.size() == 3) // three: two of them are decimal
        return splitAt(text, commas[commas.size() / 2]);
    if (const auto degrees = positionsOf("d", text); degrees.size() == 2)
        return splitAt(text, text.find_last_not_of("0123456789.,+-", degrees[1] - 1) + 1);
    std::vector<std::size_t> starts; // of numbers
    for (std::size_t at = 0; at < text.size(); ++at)
        if (blanks.find(text[at]) == blanks.npos && (at == 0 || blanks.find(text[at - 1]) != blanks.npos))
            starts.push_back(at);
    if (starts.empty() || starts.size() % 2 != 0)
        return std::nullopt;
    return splitAt(text, starts[starts.size() / 2]);
}

/// Two coordinates, in brackets or not, also below an address.
bool readPair(std::string_view text, PlaceText& place) {
    const std::size_t line = text.rfind('\n');
    if (line != text.npos && text.substr(line + 1, 1) == "(")
        text.remove_prefix(line + 1);
    place.hasBrackets = text.size() > 2 && ((text.front() == '(' && text.back() == ')') ||
                                            (text.front() == '[' && text.back() == ']'));
    if (place.hasBrackets)
        text = trimmed(text.substr(1, text.size() - 2));
    const std::string plain = withPlainMarks(text);
    const auto halves = splitPair(plain);
    const auto first = halves ? CoordinateReader(halves->first).read() : std::nullopt,
               second = halves ? CoordinateReader(halves->second).read() : std::nullopt;
    if (!first || !second || (first->axis && first->axis == second->axis))
        return false;
    place.kind = PlaceText::Kind::Pair;
    place.isOrdered = first->axis || second->axis;
    const bool isNorthFirst = first->axis == 'y' || second->axis == 'x';
    place.place =
        isNorthFirst ? glm::dvec2(second->value, first->value) : glm::dvec2(first->value, second->value);
    return true;
}

/// "POINT (2.30 48.88)", with or without z.
bool readPoint(std::string_view text, PlaceText& place) {
    const std::size_t open = text.find('(');
    if (open == text.npos || text.back() != ')')
        return false;
    const std::string name = lower(std::string(trimmed(text.substr(0, open))));
    if (name != "point" && name != "point z" && name != "pointz")
        return false;
    std::vector<double> numbers;
    for (std::string_view rest = trimmed(text.substr(open + 1, text.size() - open - 2)); !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const auto number = parseNumber(rest.substr(0, end));
        if (!number || numbers.size() == 3)
            return false;
        numbers.push_back(*number);
        rest = trimmed(rest.substr(end));
    }
    if (numbers.size() < 2)
        return false;
    place.kind = PlaceText::Kind::Point;
    place.place = {numbers[0], numbers[1]};
    if (numbers.size() == 3)
        place.z = numbers[2];
    return true;
}

/// Whether a text may be a geometry: WKT, GeoJSON, or hexadecimal WKB, of which a point has 42 digits.
bool isGeometry(std::string_view text) {
    constexpr std::size_t minHexadecimal = 42;
    const std::size_t word = std::min(
        text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz "), text.size() - 1);
    return text[0] == '{' || (word > 0 && text[word] == '(') ||
           (text.size() >= minHexadecimal && text.find_first_not_of("0123456789abcdefABCDEF") == text.npos);
}

} // namespace

std::optional<CoordinateText> parseCoordinate(std::string_view text) {
    return CoordinateReader(withPlainMarks(trimmed(text))).read();
}

PlaceText parsePlace(std::string_view text) {
    PlaceText place;
    text = trimmed(text);
    if (const std::size_t end = text.find(';'); lower(std::string(text.substr(0, 5))) == "srid=") {
        const auto srid = parseNumber(text.substr(5, std::min(end, text.size()) - 5));
        if (!srid || end == text.npos || *srid != std::floor(*srid) || *srid < 0.0 || *srid > 1e6)
            return place;
        place.srid = static_cast<int>(*srid);
        text = trimmed(text.substr(end + 1));
    }
    if (text.substr(0, 2) == "\\x") // PostgreSQL's bytes
        text.remove_prefix(2);
    if (text.empty() || readPoint(text, place))
        return place;
    if (isGeometry(text)) {
        place.kind = PlaceText::Kind::Geometry;
        place.geometry = text;
    } else if (text.size() < 400 && place.srid == 0)
        readPair(text, place);
    return place;
}

} // namespace osgTreeWind
