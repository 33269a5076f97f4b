// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TextTokens.h>
#include <osgTreeWind/windfiles/VtkImage.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/Number.h>

#include <cmath>
#include <limits>
#include <map>

namespace osgTreeWind {

namespace {

constexpr double farthest = 1e9; // metres
constexpr int mostPoints = 1000000000;

std::string upper(std::string_view word) {
    std::string text(word);
    for (char& c : text)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return text;
}

/// Bytes of one number in a binary file; 0 for a type that is not read.
std::size_t sizeOfType(const std::string& type) {
    static const std::map<std::string, std::size_t> sizes = {
        {"CHAR", 1},          {"UNSIGNED_CHAR", 1}, {"SHORT", 2}, {"UNSIGNED_SHORT", 2},
        {"INT", 4},           {"UNSIGNED_INT", 4},  {"FLOAT", 4}, {"LONG", 8},
        {"UNSIGNED_LONG", 8}, {"VTKTYPEINT64", 8},  {"DOUBLE", 8}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
}

class LegacyReader {
public:
    LegacyReader(std::string_view text, const std::string& file) : _file(file), _tokens(text, file) {}

    Result<WindContent> read() {
        readHead();
        while (_tokens.good() && !_found)
            readSection();
        if (!_tokens.good() && _binary && _inData)
            return Diagnostic{_file, 0, 0, "byte " + std::to_string(_tokens.offset()),
                              _tokens.problem().message};
        if (!_tokens.good())
            return _tokens.problem();
        return windOfVtk(std::move(_image), "VTK legacy STRUCTURED_POINTS");
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
        _binary = upper(encoding) == "BINARY";
        if (!_binary && upper(encoding) != "ASCII")
            _tokens.fail(expectedFound("ASCII or BINARY", encoding));
        expect("DATASET");
        expect("STRUCTURED_POINTS");
    }

    void readSection() {
        const std::string_view found = _tokens.next();
        const std::string word = upper(found);
        if (word == "DIMENSIONS")
            for (int axis = 0; axis < 3; ++axis)
                _image.points[axis] = _tokens.whole("a number of points of at least 1", 1, mostPoints);
        else if (word == "ORIGIN")
            for (int axis = 0; axis < 3; ++axis)
                _image.origin[axis] = _tokens.number("metres within 1e9", -farthest, farthest);
        else if (word == "SPACING" || word == "ASPECT_RATIO")
            for (int axis = 0; axis < 3; ++axis)
                _image.spacing[axis] = _tokens.number("metres above 0", 1e-6, farthest);
        else if (word == "POINT_DATA" || word == "CELL_DATA")
            readCount(word == "CELL_DATA");
        else if (word == "VECTORS" || word == "NORMALS")
            readVectors();
        else if (word == "SCALARS")
            readScalars();
        else if (word == "FIELD")
            readFields();
        else if (word.empty())
            _tokens.fail(
                "expected VECTORS, or a FIELD of 3 components, of the points; none found before the end");
        else
            _tokens.fail(expectedFound("a section of STRUCTURED_POINTS with VECTORS or FIELD data", found));
    }

    void readCount(bool ofCells) {
        if (_image.points.x < 1)
            return _tokens.fail("expected DIMENSIONS before the data");
        _image.ofCells = ofCells;
        const double count = _tokens.number("a number of points", 0, std::numeric_limits<double>::max());
        if (count != _image.count())
            _tokens.fail("expected " + numberText(_image.count()) + " as in DIMENSIONS, found " +
                         numberText(count));
        _counted = true;
    }

    void readVectors() {
        _image.name = _tokens.next();
        const std::string type = upper(_tokens.next());
        readArray(type, 3.0, _image.count(), true);
    }

    void readScalars() {
        _tokens.next(); // name
        const std::string type = upper(_tokens.next());
        TextTokens ahead = _tokens;
        const auto components = parseNumber(ahead.next());
        if (components)
            _tokens.next();
        expect("LOOKUP_TABLE");
        _tokens.next(); // name
        readArray(type, components.value_or(1.0), _image.count(), false);
    }

    void readFields() {
        _tokens.next(); // name
        const int arrays = _tokens.whole("a number of arrays from 1 to 1000", 1, 1000);
        for (int i = 0; i < arrays && _tokens.good() && !_found; ++i) {
            const std::string_view name = _tokens.next();
            const int components = _tokens.whole("a number of components of 1 to 100", 1, 100);
            const int tuples = _tokens.whole("a number of tuples", 0, std::numeric_limits<int>::max());
            const std::string type = upper(_tokens.next());
            const bool wind = components == 3 && _counted && tuples == _image.count();
            if (wind)
                _image.name = name;
            readArray(type, components, tuples, wind);
        }
    }

    /// The numbers behind an array's head; kept when they are the wind, stepped over when not.
    void readArray(const std::string& type, double components, double tuples, bool wind) {
        const std::size_t size = sizeOfType(type);
        const double numbers = components * tuples;
        if (!_tokens.good())
            return;
        if (size == 0 || (wind && type != "FLOAT" && type != "DOUBLE"))
            return _tokens.fail(expectedFound(wind ? "float or double" : "a VTK type of number", type));
        if (wind && !_counted)
            return _tokens.fail("expected POINT_DATA or CELL_DATA before the vectors");
        if (_binary)
            _tokens.restOfLine();
        _inData = true;
        const double least = _binary ? numbers * static_cast<double>(size) : 2.0 * numbers - 1.0;
        if (!(numbers >= 0.0) || least > static_cast<double>(_tokens.left()))
            return _tokens.fail("the file ends before the " + numberText(numbers) + " numbers of this array");
        const auto count = static_cast<std::size_t>(numbers);
        if (_binary) {
            const std::string_view bytes = _tokens.bytes(count * size);
            if (wind)
                _image.values = floatsOf(bytes, size == 8, ByteOrder::Big);
        } else {
            readText(count, wind);
        }
        _found = wind && _tokens.good();
        _inData = false;
    }

    void readText(std::size_t count, bool wind) {
        if (wind)
            _image.values.reserve(count);
        for (std::size_t i = 0; i < count && _tokens.good(); ++i) {
            if (!wind) {
                _tokens.next();
                continue;
            }
            TextTokens ahead = _tokens;
            const bool noData = upper(ahead.next()) == "NAN";
            if (noData)
                _tokens.next();
            _image.values.push_back(noData ? std::numeric_limits<float>::quiet_NaN()
                                           : static_cast<float>(_tokens.number("a number", -1e30, 1e30)));
        }
    }

    const std::string& _file;
    TextTokens _tokens;
    VtkImage _image;
    bool _binary = false, _counted = false, _inData = false, _found = false;
};

} // namespace

Result<WindContent> readVtkLegacy(std::string_view bytes, const std::string& file) {
    return LegacyReader(bytes, file).read();
}

} // namespace osgTreeWind
