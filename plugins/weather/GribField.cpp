// SPDX-License-Identifier: MIT
#include <plugins/weather/GribField.h>

#include <plugins/weather/GribEditions.h>

#include <osgTreeWind/base/Problem.h>

namespace osgTreeWind {

namespace {

using GribEditions::Problem;

constexpr std::string_view start = "GRIB", end = "7777";

/// A file from one message to the next.
class Walk {
public:
    explicit Walk(std::string_view bytes) : _bytes(bytes) {}

    Result<std::vector<GribField>> read(const std::string& file) {
        while ((_at = _bytes.find(start, _at)) != std::string_view::npos) {
            const std::size_t begin = _at;
            ++_message;
            if (const Problem problem = readMessage())
                return fileProblem(file, "message " + std::to_string(_message) + ", at byte " +
                                             std::to_string(begin) + ": " + *problem);
        }
        return std::move(_fields);
    }

private:
    Problem readMessage() {
        const GribBytes head(_bytes.substr(_at, 16));
        const int edition = head.whole(8);
        if (head.size() < 16)
            return "cut in its first section";
        if (edition != 1 && edition != 2)
            return "expected edition 1 or 2, found " + std::to_string(edition);
        const std::uint64_t size = edition == 1 ? head.number(5, 3) : head.number(9, 8);
        if (size > _bytes.size() - _at)
            return "expected " + std::to_string(size) + " bytes, the file ends after " +
                   std::to_string(_bytes.size() - _at);
        _end = _at + static_cast<std::size_t>(size);
        if (size < 20 || _bytes.substr(_end - end.size(), end.size()) != end)
            return "it does not end where it says, after " + std::to_string(size) + " bytes";
        _field = {};
        _field.begin = _at;
        _field.size = static_cast<std::size_t>(size);
        _end -= end.size();
        _field.parameter.edition = edition;
        _field.parameter.table = head.whole(7);
        _at += edition == 1 ? 8 : 16;
        Problem problem = edition == 1 ? readEdition1() : readEdition2();
        _at = _end + end.size();
        return problem;
    }

    /// The next section, whose length its first octets say. Null where it ends beyond the message.
    bool take(std::size_t lengthOctets, GribBytes& section) {
        const std::size_t left = _end - _at;
        const std::uint64_t length = GribBytes(_bytes.substr(_at, left)).number(1, lengthOctets);
        if (length < lengthOctets + 1 || length > left)
            return false;
        section = GribBytes(_bytes.substr(_at, static_cast<std::size_t>(length)));
        _at += static_cast<std::size_t>(length);
        return true;
    }

    static std::string cut(int number) {
        return "section " + std::to_string(number) + " is longer than what is left of the message";
    }

    Problem readEdition1() {
        GribBytes section{{}};
        if (!take(3, section))
            return cut(1);
        const int present = section.whole(8);
        if (Problem problem = GribEditions::readProduct1(section, _field))
            return problem;
        constexpr int hasGrid = 0x80, hasBitmap = 0x40;
        if (present & hasGrid) {
            if (!take(3, section))
                return cut(2);
            if (Problem problem = GribEditions::readGrid1(section, _field))
                return problem;
        } else
            _field.grid.kind = "catalogued";
        if ((present & hasBitmap) && !take(3, section))
            return cut(3);
        if (!take(3, section))
            return cut(4);
        GribEditions::readPacking1(section, _field);
        _fields.push_back(_field);
        return {};
    }

    Problem readEdition2() {
        GribBytes section{{}};
        bool hasOrigin = false, hasGrid = false, hasProduct = false;
        while (_at < _end) {
            const int number = _end - _at > 4 ? GribBytes(_bytes.substr(_at, 5)).whole(5) : 0;
            if (number < 1 || number > 7)
                return "expected a section 1 to 7, found " + std::to_string(number);
            if (!take(4, section))
                return cut(number);
            Problem problem;
            if (number == 1) {
                problem = GribEditions::readOrigin2(section, _field);
                hasOrigin = true;
            } else if (number == 3) {
                problem = GribEditions::readGrid2(section, _field);
                hasGrid = true;
            } else if (number == 4) {
                problem = GribEditions::readProduct2(section, _field);
                hasProduct = true;
            } else if (number == 5)
                GribEditions::readPacking2(section, _field);
            else if (number == 7) {
                if (!hasOrigin || !hasGrid || !hasProduct)
                    return "numbers without sections 1, 3 and 4";
                _fields.push_back(_field);
                ++_field.band;
                hasProduct = false;
            }
            if (problem)
                return problem;
        }
        return hasProduct ? Problem("section 4 without numbers") : Problem();
    }

    std::string_view _bytes;
    std::size_t _at = 0, _end = 0, _message = 0;
    GribField _field;
    std::vector<GribField> _fields;
};

} // namespace

Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file) {
    Result<std::vector<GribField>> fields = Walk(bytes).read(file);
    if (fields && fields.value().empty())
        return fileProblem(file, "holds no field of GRIB");
    return fields;
}

} // namespace osgTreeWind
