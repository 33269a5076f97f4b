// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

std::optional<Diagnostic> problemOfInput(const std::string& path) {
    const Result<std::ifstream> input = openInput(path);
    return input ? std::nullopt : std::optional(input.problems().front());
}

Result<std::ifstream> openInput(const std::string& path) {
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(toPath(path), problem);
    if (status.type() == std::filesystem::file_type::not_found)
        return fileProblem(path, "no such file");
    if (problem)
        return fileProblem(path, "cannot be read");
    if (!std::filesystem::is_regular_file(status))
        return fileProblem(path, "not a regular file");
    std::ifstream input(toPath(path), std::ios::binary);
    if (!input)
        return fileProblem(path, "cannot be read");
    return input;
}

Result<std::string> readBytes(const std::string& path) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return input.problems();
    return readBytes(input.value(), path);
}

Result<std::string> readBytes(std::ifstream& file, const std::string& path) {
    file.clear(); // the end of the file may have been reached before
    const std::streamoff size = file.seekg(0, std::ios::end).tellg();
    if (const std::string memory =
            problemOfMemory("its bytes", static_cast<std::uint64_t>(std::max<std::streamoff>(size, 0)));
        !memory.empty())
        return fileProblem(path, memory);
    std::string bytes(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)), '\0');
    file.seekg(0).read(&bytes[0], size);
    if (size < 0 || file.bad())
        return fileProblem(path, "cannot be read");
    bytes.resize(static_cast<std::size_t>(file.gcount())); // fewer if the file was truncated meanwhile
    if (bytes.empty())
        return fileProblem(path, "the file is empty");
    return bytes;
}

Result<std::string> readHead(const std::string& path, std::size_t size) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return input.problems();
    std::string head = readHead(input.value(), size);
    if (head.empty())
        return fileProblem(path, "the file is empty");
    return head;
}

std::string readHead(std::istream& file, std::size_t size) {
    std::string head(size, '\0');
    file.read(head.data(), static_cast<std::streamsize>(size));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

Result<std::string> readTextFile(const std::string& path) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return input.problems();
    return readText(input.value(), path);
}

} // namespace osgTreeWind
