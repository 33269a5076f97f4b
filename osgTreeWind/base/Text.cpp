// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Text.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Problem.h>

namespace osgTreeWind {

namespace {

bool isBinary(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\r' && c != '\n' && c != '\f') || byte == 0x7f;
}

} // namespace

TextPosition positionInText(std::string_view text, std::size_t offset) {
    TextPosition position;
    offset = std::min(offset, text.size());
    for (std::size_t i = 0; i < offset; ++i) {
        const bool lineEnds =
            text[i] == '\n' || (text[i] == '\r' && (i + 1 >= text.size() || text[i + 1] != '\n'));
        position =
            lineEnds ? TextPosition{position.line + 1, 1} : TextPosition{position.line, position.column + 1};
    }
    return position;
}

Result<std::string_view> plainText(std::string_view bytes, const std::string& file) {
    if (bytes.substr(0, 3) == "\xEF\xBB\xBF")
        bytes.remove_prefix(3);
    if (bytes.empty())
        return fileProblem(file, "the file is empty");
    const auto binary = std::find_if(bytes.begin(), bytes.end(), isBinary);
    if (binary == bytes.end())
        return bytes;
    const TextPosition position = positionInText(bytes, static_cast<std::size_t>(binary - bytes.begin()));
    return Diagnostic{file, position.line, position.column, {}, "expected text, found binary data"};
}

Result<std::string> readText(std::istream& input, const std::string& file) {
    constexpr std::size_t large = std::size_t(1) << 26;
    std::string text;
    char buffer[1 << 14];
    while (input.read(buffer, sizeof buffer) || input.gcount() > 0) {
        const std::size_t read = static_cast<std::size_t>(input.gcount()), size = text.size() + read;
        if (size > large && size > text.capacity()) // the capacity doubles
            if (const std::string memory = problemOfMemory("its bytes", 2 * size); !memory.empty())
                return fileProblem(file, memory);
        text.append(buffer, read);
    }
    if (!input.eof() || input.bad())
        return fileProblem(file, "cannot be read");
    const Result<std::string_view> plain = plainText(text, file);
    if (!plain)
        return plain.problems();
    text.erase(0, text.size() - plain.value().size());
    return text;
}

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

} // namespace osgTreeWind
