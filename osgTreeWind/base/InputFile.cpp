// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <filesystem>

#include <unistd.h>

namespace osgTreeWind {

std::optional<Diagnostic> problemOfInput(const std::string& path) {
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(path, problem);
    if (status.type() == std::filesystem::file_type::not_found)
        return fileProblem(path, "no such file");
    if (!problem && !std::filesystem::is_regular_file(status))
        return fileProblem(path, "not a regular file");
    if (problem || access(path.c_str(), R_OK) != 0)
        return fileProblem(path, "cannot be read");
    return std::nullopt;
}

Result<std::ifstream> openInput(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    std::ifstream input(path, std::ios::binary);
    if (!input)
        return fileProblem(path, "cannot be read");
    return input;
}

Result<std::string> readTextFile(const std::string& path) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return input.problems();
    return readText(input.value(), path);
}

} // namespace osgTreeWind
