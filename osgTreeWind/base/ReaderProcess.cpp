// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProcess.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <filesystem>
#include <system_error>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

/// The path of the program: the environment variable, or else osgTreeWind/ beside the library. A program that
/// links the library statically searches beside itself, then the folders of the installation and the build.
std::string pathOf(const ReaderProgram& reader) {
    if (const auto path = environmentVariable(reader.variable))
        return *path;
    std::error_code ignored;
    const fs::path folder = libraryPath().parent_path(),
                   name = fs::path("osgTreeWind") / (std::string(reader.name) + programSuffix);
    for (const char* libraries : {"", OSGTREEWIND_LIBRARY_FOLDERS}) // relative to the library or absolute
        if (fs::exists(folder / libraries / name, ignored))
            return toText(folder / libraries / name);
    return toText(folder / name);
}

} // namespace

ReaderProcess::ReaderProcess(const ReaderProgram& reader, const std::vector<std::string>& arguments) {
    const std::string program = pathOf(reader),
                      problem = _program.start(program, arguments, ChildProcess::Connection::InputAndOutput);
    if (!problem.empty())
        _startProblem = std::string(reader.format) + " needs " + reader.library + ", and the program " +
                        program + ": " + problem;
}

std::string ReaderProcess::problem() {
    if (const std::string reason = _program.finish().reason; !reason.empty())
        _endProblem = "its reader " + reason;
    return _startProblem.empty() ? _endProblem : _startProblem;
}

} // namespace osgTreeWind
