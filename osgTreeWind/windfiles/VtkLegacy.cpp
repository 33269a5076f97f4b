// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TextTokens.h>
#include <osgTreeWind/windfiles/VtkImage.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr int maxVtkPoints = 1000000000;

std::string upper(std::string_view word) {
    std::string text(word);
    for (char& c : text)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return text;
}

/// Bits of a number in a binary file; 0 for an unsupported type.
std::size_t bitsOfType(const std::string& type) {
    static const std::map<std::string, std::size_t> sizes = {
        {"BIT", 1},           {"CHAR", 8},           {"SIGNED_CHAR", 8},
        {"UNSIGNED_CHAR", 8}, {"SHORT", 16},         {"UNSIGNED_SHORT", 16},
        {"INT", 32},          {"UNSIGNED_INT", 32},  {"VTKIDTYPE", 32},
        {"FLOAT", 32},        {"LONG", 64},          {"UNSIGNED_LONG", 64},
        {"VTKTYPEINT64", 64}, {"VTKTYPEUINT64", 64}, {"DOUBLE", 64}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
}

bool isReal(const std::string& type) {
    return type == "FLOAT" || type == "DOUBLE";
}

class LegacyReader {
public:
    LegacyReader(std::string_view text, const std::string& file, const std::vector<std::string>& variable)
        : _file(file), _variable(variable), _tokens(text, file) {}

    Result<WindContent> read() {
        readHead();
        while (_tokens.good() && !_isAtEnd)
            readSection();
        if (_tokens.good())
            readWind();
        if (!_tokens.good() && _isBinary && _isInData)
            return Diagnostic{_file, 0, 0, "byte " + std::to_string(_tokens.offset()),
                              _tokens.problem().message};
        if (!_tokens.good())
            return _tokens.problem();
        return windFromVtk(std::move(_image), "VTK legacy " + _dataset);
    }

private:
    void expect(const char* word) {
        const std::string_view found = _tokens.next();
        if (upper(found) != word)
            _tokens.fail(expectedFound(word, found));
    }

    void readHead() {
        _tokens.restOfLine(); // "# vtk DataFile Version", by which the format was recognised
        _tokens.restOfLine(); // title
        const std::string_view encoding = _tokens.next();
        _isBinary = upper(encoding) == "BINARY";
        if (!_isBinary && upper(encoding) != "ASCII")
            _tokens.fail(expectedFound("ASCII or BINARY", encoding));
        expect("DATASET");
        const std::string_view dataset = _tokens.next();
        _dataset = upper(dataset);
        if (_dataset != "STRUCTURED_POINTS" && _dataset != "RECTILINEAR_GRID" &&
            _dataset != "STRUCTURED_GRID")
            _tokens.fail(expectedFound("STRUCTURED_POINTS, or evenly spaced points as RECTILINEAR_GRID or "
                                       "STRUCTURED_GRID",
                                       dataset));
    }

    void readSection() {
        const std::string_view found = _tokens.next();
        const std::string word = upper(found);
        if (word == "POINT_DATA" || word == "CELL_DATA")
            readCount(word == "CELL_DATA");
        else if (word == "FIELD")
            readFields();
        else if (word == "METADATA")
            skipMetadata();
        else if (word.empty())
            _isAtEnd = true;
        else if (!(_isCountRead ? readAttribute(word) : readGeometry(word)))
            _tokens.fail(expectedFound("a section of " + _dataset + " with VECTORS or FIELD data", found));
    }

    /// @return false if the section does not belong to this type of dataset.
    bool readGeometry(const std::string& word) {
        const bool evenByKind = _dataset == "STRUCTURED_POINTS";
        if (word == "DIMENSIONS")
            for (int axis = 0; axis < 3; ++axis)
                _image.points[axis] = _tokens.integer("a number of points of at least 1", 1, maxVtkPoints);
        else if (evenByKind && word == "ORIGIN")
            for (int axis = 0; axis < 3; ++axis)
                _image.origin[axis] = _tokens.number("metres within 1e9", -maxCoordinate, maxCoordinate);
        else if (evenByKind && (word == "SPACING" || word == "ASPECT_RATIO"))
            for (int axis = 0; axis < 3; ++axis)
                _image.spacing[axis] = _tokens.number("metres above 0", 0.0, maxCoordinate);
        else if (_dataset == "RECTILINEAR_GRID" && word.size() == 13 && word.substr(1) == "_COORDINATES" &&
                 word[0] >= 'X' && word[0] <= 'Z')
            readCoordinates(word[0] - 'X');
        else if (_dataset == "STRUCTURED_GRID" && word == "POINTS")
            readPoints();
        else
            return false;
        return true;
    }

    /// Reads or skips an attribute of points or cells. @return false if it is unknown.
    bool readAttribute(const std::string& word) {
        static const std::map<std::string, double> components = {{"NORMALS", 3.0},    {"TENSORS", 9.0},
                                                                 {"TENSORS6", 6.0},   {"EDGE_FLAGS", 1.0},
                                                                 {"GLOBAL_IDS", 1.0}, {"PEDIGREE_IDS", 1.0}};
        const auto known = components.find(word);
        if (word == "VECTORS") {
            const std::string_view name = _tokens.next();
            noteArray(name, upper(_tokens.next()), 3.0, true);
        } else if (word == "SCALARS")
            readScalars();
        else if (word == "COLOR_SCALARS" || word == "LOOKUP_TABLE")
            readColours(word == "LOOKUP_TABLE");
        else if (word == "TEXTURE_COORDINATES") {
            _tokens.next(); // name
            const int width = _tokens.integer("1 to 3 components", 1, 3);
            skipArray(upper(_tokens.next()), width * _image.vectorCount());
        } else if (known != components.end()) {
            _tokens.next(); // name
            skipArray(upper(_tokens.next()), known->second * _image.vectorCount());
        } else {
            return false;
        }
        return true;
    }

    void readCount(bool ofCells) {
        if (_image.points.x < 1)
            return _tokens.fail("expected DIMENSIONS before the data");
        if (_dataset != "STRUCTURED_POINTS" && _knownAxes != 7u)
            return _tokens.fail("expected the coordinates of the points before the data");
        if (const std::string problem = _image.normalizeSpacing(); !problem.empty())
            return _tokens.fail(problem);
        _image.ofCells = ofCells;
        expectCount("a number of points", 0.0, _image.vectorCount());
        _isCountRead = true;
    }

    /// Reads a count and compares it with DIMENSIONS.
    void expectCount(const char* what, double least, double wanted) {
        const double count = _tokens.number(what, least, std::numeric_limits<double>::max());
        if (count != wanted)
            _tokens.fail("expected " + numberText(wanted) + " as in DIMENSIONS, found " + numberText(count));
    }

    void readCoordinates(int axis) {
        if (_image.points.x < 1)
            return _tokens.fail("expected DIMENSIONS before the coordinates");
        expectCount("a number of coordinates", 1.0, _image.points[axis]);
        std::vector<double> places;
        readArray(upper(_tokens.next()), _image.points[axis], places);
        if (_tokens.good())
            setAxis(axis, places, 1);
    }

    void readPoints() {
        if (_image.points.x < 1)
            return _tokens.fail("expected DIMENSIONS before the points");
        expectCount("a number of points", 1.0, _image.vectorCount());
        std::vector<double> places;
        readArray(upper(_tokens.next()), 3.0 * _image.vectorCount(), places);
        std::size_t repeats = 1;
        for (int axis = 0; axis < 3 && _tokens.good(); ++axis) {
            std::vector<double> along(places.size() / 3);
            for (std::size_t i = 0; i < along.size(); ++i)
                along[i] = places[3 * i + static_cast<std::size_t>(axis)];
            setAxis(axis, along, repeats);
            repeats *= static_cast<std::size_t>(_image.points[axis]);
        }
    }

    /// Sets origin and spacing of an axis from its coordinates, each repeated `repeats` times in a row.
    void setAxis(int axis, const std::vector<double>& places, std::size_t repeats) {
        const auto points = static_cast<std::size_t>(_image.points[axis]);
        const double first = places.front(), last = places[(points - 1) * repeats];
        const double spacing = points > 1 ? (last - first) / static_cast<double>(points - 1) : 1.0;
        const char axisName = static_cast<char>('x' + axis);
        _knownAxes |= 1u << static_cast<unsigned>(axis);
        if (axis == 2 && setLevels(places, points, repeats))
            return;
        if (!(std::abs(first) <= maxCoordinate && spacing >= 1e-6 && spacing <= maxCoordinate))
            return _tokens.fail(std::string("expected increasing metres within 1e9 along ") + axisName);
        // coordinates may be floats written with six digits
        const double tolerance = 0.001 * spacing + 1e-6 * std::max(std::abs(first), std::abs(last));
        for (std::size_t i = 0; i < places.size(); ++i)
            if (!(std::abs(places[i] - first - spacing * static_cast<double>(i / repeats % points)) <=
                  tolerance))
                return _tokens.fail(std::string("expected points evenly spaced along ") + axisName + ", " +
                                    numberText(spacing) + " m apart from " + numberText(first) +
                                    " on; number " + std::to_string(i + 1) + " is at " +
                                    numberText(places[i]));
        _image.origin[axis] = first;
        _image.spacing[axis] = spacing;
    }

    /// Sets VtkImage::levels if layers are horizontal and unevenly spaced. @return whether they are.
    bool setLevels(const std::vector<double>& places, std::size_t points, std::size_t repeats) {
        std::vector<float> levels;
        bool isEven = true;
        for (std::size_t i = 0; i < points; ++i) {
            const double height = places[i * repeats];
            const auto begin = places.begin() + static_cast<std::ptrdiff_t>(i * repeats);
            const bool isLevel = std::all_of(begin, begin + static_cast<std::ptrdiff_t>(repeats),
                                             [&](double each) { return std::abs(each - height) < 1e-3; });
            if (!isLevel || !(std::abs(height) <= maxCoordinate) ||
                (i > 0 && !(height > places[(i - 1) * repeats])))
                return false;
            const double even = places[0] + (places[(points - 1) * repeats] - places[0]) *
                                                static_cast<double>(i) /
                                                std::max(1.0, static_cast<double>(points) - 1.0);
            isEven = isEven && std::abs(height - even) <= 1e-3 * std::max(1.0, std::abs(even));
            levels.push_back(static_cast<float>(height));
        }
        if (!isEven)
            _image.levels = std::move(levels);
        return !isEven;
    }

    /// Notes where an array begins, and skips it.
    void noteArray(std::string_view name, const std::string& type, double components, bool isActive) {
        _arrays.push_back({std::string(name), components, _image.ofCells, isActive});
        _places.emplace_back(type, _tokens);
        skipArray(type, components * _image.vectorCount());
    }

    void readWind() {
        const TextTokens end = _tokens;
        const auto read = [&](std::size_t i, std::vector<float>& values) {
            _tokens = _places[i].second;
            readArray(_places[i].first, _arrays[i].components * _image.vectorCount(), values);
            return _tokens.good();
        };
        if (const std::string problem = readVtkWind(_arrays, _variable, read, _image); !problem.empty()) {
            _tokens = end;
            _tokens.fail(problem);
        }
    }

    void readScalars() {
        const std::string_view name = _tokens.next();
        const std::string type = upper(_tokens.next());
        TextTokens ahead = _tokens;
        const auto components = parseNumber(ahead.next());
        if (components)
            _tokens.next();
        expect("LOOKUP_TABLE");
        _tokens.next(); // name
        noteArray(name, type, components.value_or(1.0), false);
    }

    void readColours(bool table) {
        _tokens.next(); // name
        const int number = _tokens.integer("a number of colours or components", 1, maxVtkPoints);
        skipArray("UNSIGNED_CHAR", table ? 4.0 * number : number * _image.vectorCount());
    }

    void readFields() {
        _tokens.next(); // name
        const int arrays = _tokens.integer("a number of arrays from 0 to 1000", 0, 1000);
        for (int i = 0; i < arrays && _tokens.good(); ++i) {
            std::string_view name = _tokens.next();
            if (upper(name) == "METADATA") {
                skipMetadata();
                name = _tokens.next();
            }
            const int components = _tokens.integer("a number of components of 0 to 100", 0, 100);
            const int tuples = _tokens.integer("a number of tuples", 0, std::numeric_limits<int>::max());
            const std::string type = upper(_tokens.next());
            const double numbers = static_cast<double>(components) * tuples;
            if (_isCountRead && tuples == _image.vectorCount()) {
                noteArray(name, type, components, false);
            } else if (name == "TimeValue" && !_isCountRead && numbers == 1.0 && isReal(type)) {
                std::vector<double> time;
                readArray(type, 1.0, time);
                if (_tokens.good() && !(std::abs(time.front()) <= maxTime))
                    _tokens.fail("expected a TimeValue within 1e15 s, found " + numberText(time.front()));
                if (_tokens.good())
                    _image.time = time.front();
            } else {
                skipArray(type, numbers);
            }
        }
    }

    /// Skips metadata of an array, up to an empty line.
    void skipMetadata() {
        _tokens.restOfLine();
        while (_tokens.remaining() > 0 && !_tokens.restOfLine().empty())
            ;
    }

    /// Moves to the first number of an array. @return false, with a problem, if the file is too short.
    bool beginArray(double numbers, std::size_t bits) {
        if (!_tokens.good())
            return false;
        if (_isBinary)
            _tokens.restOfLine();
        _isInData = true;
        const double least =
            _isBinary ? std::ceil(numbers * static_cast<double>(bits) / 8.0) : 2.0 * numbers - 1.0;
        if (!(numbers >= 0.0) || least > static_cast<double>(_tokens.remaining()))
            _tokens.fail("the file ends before the " + numberText(numbers) + " numbers of this array");
        return _tokens.good();
    }

    template <typename T>
    void readArray(const std::string& type, double numbers, std::vector<T>& values) {
        if (_tokens.good() && !isReal(type))
            return _tokens.fail(expectedFound("float or double", type));
        const std::size_t size = type == "DOUBLE" ? 8 : 4;
        if (!beginArray(numbers, 8 * size))
            return;
        const auto count = static_cast<std::size_t>(numbers);
        values.reserve(count);
        if (_isBinary)
            values = numbersOf<T>(_tokens.bytes(count * size), size == 8, ByteOrder::Big);
        for (std::size_t i = 0; !_isBinary && i < count && _tokens.good(); ++i)
            values.push_back(static_cast<T>(textNumber()));
        _isInData = !_tokens.good();
    }

    double textNumber() {
        const std::string_view word = _tokens.next();
        const auto value = parseNumber(word);
        if (value && std::abs(*value) <= 1e30)
            return *value;
        if (upper(word) != "NAN")
            _tokens.fail(expectedFound("a number", word));
        return std::numeric_limits<double>::quiet_NaN();
    }

    void skipArray(const std::string& type, double numbers) {
        if (type == "STRING")
            return skipTexts(numbers);
        const std::size_t bits = bitsOfType(type);
        if (_tokens.good() && bits == 0)
            return _tokens.fail(expectedFound("a VTK type of number", type));
        if (!beginArray(numbers, bits))
            return;
        const auto count = static_cast<std::size_t>(numbers);
        if (_isBinary)
            _tokens.bytes((count * bits + 7) / 8);
        for (std::size_t i = 0; !_isBinary && i < count; ++i)
            _tokens.next();
        _isInData = false;
    }

    /// Skips strings: one per line; in binary each after its length, whose own size is in its first two bits.
    void skipTexts(double number) {
        if (_tokens.good())
            _tokens.restOfLine();
        for (double i = 0; i < number && _tokens.good(); ++i) {
            if (_tokens.remaining() == 0) {
                _tokens.fail("the file ends before the " + numberText(number) + " texts of this array");
            } else if (!_isBinary) {
                _tokens.restOfLine();
            } else {
                const auto first = static_cast<unsigned char>(_tokens.bytes(1).front());
                std::size_t length = first & 0x3fu;
                for (const char byte : _tokens.bytes((std::size_t(8) >> (first >> 6)) - 1))
                    length = length << 8 | static_cast<unsigned char>(byte);
                _tokens.bytes(length);
            }
        }
    }

    const std::string& _file;
    const std::vector<std::string>& _variable;
    TextTokens _tokens;
    std::vector<VtkArray> _arrays;
    std::vector<std::pair<std::string, TextTokens>> _places; ///< Type and beginning of each array.
    VtkImage _image;
    std::string _dataset;
    unsigned _knownAxes = 0; // a bit for each axis whose coordinates are known
    bool _isBinary = false, _isCountRead = false, _isInData = false, _isAtEnd = false;
};

} // namespace

Result<WindContent> readVtkLegacy(std::string_view bytes, const std::string& file,
                                  const std::vector<std::string>& variable) {
    return LegacyReader(bytes, file, variable).read();
}

} // namespace osgTreeWind
