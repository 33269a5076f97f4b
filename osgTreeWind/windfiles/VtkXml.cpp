// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TextTokens.h>
#include <osgTreeWind/windfiles/VtkImage.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <pugixml.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

/// A problem at an offset of the file.
struct Problem {
    std::ptrdiff_t offset;
    std::string key;
    std::string message;
};

class XmlReader {
public:
    XmlReader(std::string_view bytes, const std::string& file, const std::vector<std::string>& variable)
        : _bytes(bytes), _file(file), _variable(variable) {}

    Result<WindContent> read() {
        if (!parse() || !readPacking() || !readGrid() || !readVectors()) {
            const TextPosition place = positionInText(_bytes, static_cast<std::size_t>(_problem.offset));
            return Diagnostic{_file, place.line, place.column, _problem.key, _problem.message};
        }
        return windFromVtk(std::move(_image), "VTK XML ImageData");
    }

private:
    bool fail(std::ptrdiff_t offset, const std::string& key, const std::string& message) {
        _problem = {offset, key, message};
        return false;
    }
    bool fail(pugi::xml_node at, const std::string& key, const std::string& message) {
        return fail(at.offset_debug(), key, message);
    }

    /// Parses only the XML before the appended data, which may contain any byte.
    bool parse() {
        std::string closed;
        std::string_view xml = _bytes;
        const std::size_t appended = _bytes.find("<AppendedData");
        if (appended != std::string_view::npos) {
            const std::size_t end = _bytes.find('>', appended);
            const std::size_t mark = end == std::string_view::npos ? end : _bytes.find('_', end);
            if (mark == std::string_view::npos)
                return fail(static_cast<std::ptrdiff_t>(appended), "AppendedData",
                            "expected _ before the data");
            xml = closed = std::string(_bytes.substr(0, end + 1)) + "</AppendedData></VTKFile>";
            _appended = _bytes.substr(mark + 1);
        }
        const pugi::xml_parse_result parsed = _document.load_buffer(xml.data(), xml.size());
        return parsed || fail(parsed.offset, {}, std::string("broken XML: ") + parsed.description());
    }

    /// Reads an attribute of two possible words, by default the first; sets `flag` for the second.
    bool readFlag(pugi::xml_node node, const char* key, const char* first, const char* second, bool& flag) {
        const std::string word = node.attribute(key).as_string(first);
        flag = word == second;
        return flag || word == first ||
               fail(node, key, expectedFound(std::string(first) + " or " + second, word));
    }

    bool readPacking() {
        const pugi::xml_node root = _document.child("VTKFile");
        bool bigEndian = false, raw = false;
        if (std::string(root.attribute("type").value()) != "ImageData")
            return fail(root, "type", expectedFound("ImageData", root.attribute("type").value()));
        if (!readFlag(root, "byte_order", "LittleEndian", "BigEndian", bigEndian) ||
            !readFlag(root, "header_type", "UInt32", "UInt64", _packing.wideHeader) ||
            !readFlag(root, "compressor", "", "vtkZLibDataCompressor", _packing.zlib) ||
            !readFlag(root.child("AppendedData"), "encoding", "base64", "raw", raw))
            return false;
        _packing.order = bigEndian ? ByteOrder::Big : ByteOrder::Little;
        _appendedRaw = raw;
        return true;
    }

    /// Reads the numbers of an attribute. @param absent its default.
    template <std::size_t N>
    bool readNumbers(pugi::xml_node node, const char* key, double (&numbers)[N], double low, double high,
                     const char* absent) {
        const std::string text = node.attribute(key).as_string(absent);
        TextTokens tokens(text, {});
        for (double& number : numbers)
            number = tokens.number("numbers", low, high);
        if (tokens.good() && tokens.next().empty())
            return true;
        return fail(
            node, key,
            expectedFound(std::to_string(N) + " numbers from " + numberText(low) + " to " + numberText(high),
                          text));
    }

    bool readGrid() {
        const pugi::xml_node image = _document.child("VTKFile").child("ImageData");
        _piece = image.child("Piece");
        if (!image || !_piece || _piece.next_sibling("Piece"))
            return fail(image, "ImageData", "expected one Piece");
        double extent[6], origin[3], spacing[3], direction[9], whole[6];
        if (!readNumbers(image, "WholeExtent", whole, -maxCoordinate, maxCoordinate, "") ||
            !readNumbers(_piece, "Extent", extent, -maxCoordinate, maxCoordinate, "") ||
            !readNumbers(image, "Origin", origin, -maxCoordinate, maxCoordinate, "0 0 0") ||
            !readNumbers(image, "Spacing", spacing, 0.0, maxCoordinate, "1 1 1") ||
            !readNumbers(image, "Direction", direction, -1.0, 1.0, "1 0 0 0 1 0 0 0 1"))
            return false;
        for (int i = 0; i < 9; ++i)
            if (direction[i] != (i % 4 == 0 ? 1.0 : 0.0))
                return fail(image, "Direction", "expected a grid that is not turned, 1 0 0 0 1 0 0 0 1");
        for (int axis = 0; axis < 3; ++axis) {
            const double first = extent[2 * axis], last = extent[2 * axis + 1];
            if (first != std::floor(first) || last != std::floor(last) || first > last ||
                last - first >= maxCoordinate || first != whole[2 * axis] || last != whole[2 * axis + 1])
                return fail(_piece, "Extent",
                            "expected whole numbers, first before last, the same as WholeExtent");
            _image.points[axis] = static_cast<int>(last - first) + 1;
            _image.spacing[axis] = spacing[axis];
            _image.origin[axis] = origin[axis] + first * spacing[axis];
        }
        if (const std::string problem = _image.normalizeSpacing(); !problem.empty())
            return fail(image, "Spacing", problem);
        return true;
    }

    bool readVectors() {
        std::vector<VtkArray> arrays;
        std::vector<pugi::xml_node> nodes;
        for (const char* place : {"PointData", "CellData"}) {
            const pugi::xml_node data = _piece.child(place);
            for (const pugi::xml_node node : data.children("DataArray")) {
                const std::string name = node.attribute("Name").value();
                if (!name.empty() && name == data.attribute("Normals").value())
                    continue;
                arrays.push_back({name, node.attribute("NumberOfComponents").as_double(1.0),
                                  place == std::string("CellData"),
                                  !name.empty() && name == data.attribute("Vectors").value()});
                nodes.push_back(node);
            }
        }
        const auto read = [&](std::size_t i, std::vector<float>& values) {
            return readArray(nodes[i], arrays[i].components, values);
        };
        const std::string problem = readVtkWind(arrays, _variable, read, _image);
        return problem.empty() ? _problem.message.empty() : fail(_piece, "PointData", problem);
    }

    /// @param components of each point or cell.
    bool readArray(pugi::xml_node array, double components, std::vector<float>& values) {
        const double count = components * _image.vectorCount();
        bool wide = false;
        if (!readFlag(array, "type", "Float32", "Float64", wide))
            return false;
        const std::string format = array.attribute("format").as_string("ascii");
        if (format == "ascii")
            return readText(array, count, values);
        if (format != "binary" && format != "appended")
            return fail(array, "format", expectedFound("ascii, binary or appended", format));
        const std::string_view packed = format == "binary" ? array.child_value() : appendedAt(array);
        if (packed.empty())
            return fail(array, format == "binary" ? "DataArray" : "offset",
                        "expected data there, found none");
        _packing.base64 = format == "binary" || !_appendedRaw;
        const Result<std::string> bytes = unpackVtk(packed, _packing, count * (wide ? 8 : 4));
        if (!bytes)
            return fail(array, array.attribute("Name").value(), bytes.problems().front().message);
        values = numbersOf<float>(bytes.value(), wide, _packing.order);
        return true;
    }

    std::string_view appendedAt(pugi::xml_node array) const {
        const auto offset = parseNumber(array.attribute("offset").value());
        if (!offset || *offset < 0.0 || *offset >= static_cast<double>(_appended.size()))
            return {};
        return _appended.substr(static_cast<std::size_t>(*offset));
    }

    bool readText(pugi::xml_node array, double count, std::vector<float>& values) {
        const std::string_view text = array.child_value();
        if (2.0 * count - 1.0 > static_cast<double>(text.size()))
            return fail(array, array.attribute("Name").value(),
                        "the data end before " + numberText(count) + " numbers");
        TextTokens tokens(text, {});
        values.reserve(static_cast<std::size_t>(count));
        for (double i = 0; i < count && tokens.good(); ++i)
            values.push_back(static_cast<float>(tokens.number("a number", -1e30, 1e30)));
        if (tokens.good())
            if (const std::string_view extra = tokens.next(); !extra.empty())
                tokens.fail(expectedFound("the end after " + numberText(count) + " numbers", extra));
        return tokens.good() ||
               fail(array.first_child().offset_debug() + static_cast<std::ptrdiff_t>(tokens.offset()),
                    array.attribute("Name").value(), tokens.problem().message);
    }

    std::string_view _bytes, _appended;
    const std::string& _file;
    const std::vector<std::string>& _variable;
    pugi::xml_document _document;
    pugi::xml_node _piece;
    VtkPacking _packing;
    bool _appendedRaw = false;
    VtkImage _image;
    Problem _problem{0, {}, {}};
};

} // namespace

Result<WindContent> readVtkXml(std::string_view bytes, const std::string& file,
                               const std::vector<std::string>& variable) {
    return XmlReader(bytes, file, variable).read();
}

} // namespace osgTreeWind
