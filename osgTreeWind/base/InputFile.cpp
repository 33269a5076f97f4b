// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <filesystem>

#include <unistd.h>

namespace osgTreeWind {

namespace {

/// Why what is there is no regular file.
std::optional<Diagnostic> problemOfKind(const std::string& path) {
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(path, problem);
    if (status.type() == std::filesystem::file_type::not_found)
        return fileProblem(path, "no such file");
    if (problem)
        return fileProblem(path, "cannot be read");
    if (!std::filesystem::is_regular_file(status))
        return fileProblem(path, "not a regular file");
    return std::nullopt;
}

} // namespace

std::optional<Diagnostic> problemOfInput(const std::string& path) {
    if (auto problem = problemOfKind(path))
        return problem;
    if (access(path.c_str(), R_OK) != 0)
        return fileProblem(path, "cannot be read");
    return std::nullopt;
}

Result<std::ifstream> openInput(const std::string& path) {
    if (const auto problem = problemOfKind(path))
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
