// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvReader.h>

#include <utility>

namespace osgTreeWind {

namespace {

constexpr unsigned char strict = CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL;

std::size_t lineLength(std::string_view text) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos)
        return text.size();
    return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
}

} // namespace

CsvReader::CsvReader(std::string_view text, std::string file, const CsvFormat& format)
    : _text(text), _file(std::move(file)), _comment(format.comment) {
    csv_init(&_parser, strict);
    csv_set_delim(&_parser, static_cast<unsigned char>(format.delimiter));
    while (_line + 1 < format.firstLine && !_text.empty()) {
        _text.remove_prefix(lineLength(_text));
        ++_line;
    }
}

CsvReader::~CsvReader() {
    csv_free(&_parser);
}

Result<bool> CsvReader::next() {
    _row.cells.clear();
    _isRowComplete = false;
    while (!_isRowComplete && !_text.empty()) {
        const std::size_t length = lineLength(_text);
        ++_line;
        if (!_isInRow) {
            if (!_comment.empty() && _text.compare(0, _comment.size(), _comment) == 0) {
                _text.remove_prefix(length);
                continue;
            }
            _row.line = _line;
        }
        _isInRow = true;
        const std::size_t parsed = parse(length);
        if (parsed != length)
            return problem(_line, static_cast<int>(parsed) + 1,
                           "misplaced quotation mark; expected \"\" inside quotes");
        _text.remove_prefix(length);
    }
    if (!_isRowComplete && !std::exchange(_isFlushed, true) &&
        csv_fini(&_parser, &onCell, &onRowEnd, this) != 0)
        return problem(_row.line, 0, "quotation mark is never closed");
    return _isRowComplete;
}

/// Parses bytes of the text. @return their number, less after an error.
std::size_t CsvReader::parse(std::size_t length) {
    std::size_t parsed = csv_parse(&_parser, _text.data(), length, &onCell, &onRowEnd, this);
    while (parsed < length && csv_error(&_parser) == CSV_EPARSE && !_parser.quoted) {
        csv_set_opts(&_parser, 0);
        parsed += csv_parse(&_parser, _text.data() + parsed, 1, &onCell, &onRowEnd, this);
        csv_set_opts(&_parser, strict);
        parsed += csv_parse(&_parser, _text.data() + parsed, length - parsed, &onCell, &onRowEnd, this);
    }
    return parsed;
}

void CsvReader::onCell(void* cell, std::size_t length, void* self) {
    static_cast<CsvReader*>(self)->_row.cells.emplace_back(static_cast<const char*>(cell), length);
}

void CsvReader::onRowEnd(int, void* self) {
    auto& reader = *static_cast<CsvReader*>(self);
    reader._isInRow = false;
    if (!reader._row.cells.empty()) // otherwise a blank line, or the LF of a CR LF
        reader._isRowComplete = true;
}

Diagnostic CsvReader::problem(int line, int column, const char* syntax) const {
    const int error = csv_error(&_parser);
    return {_file, line, column, {}, error == CSV_EPARSE ? syntax : csv_strerror(error)};
}

} // namespace osgTreeWind
