// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ForestFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/places/MapProgram.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

namespace osgTreeWind {

namespace {

std::string absolute(const std::string& folder) {
    if (folder.find("://") != std::string::npos) // URL
        return folder;
    std::error_code ignored;
    const std::filesystem::path path = folder.empty() ? "." : toPath(folder);
    std::string result = toText(std::filesystem::absolute(path, ignored).lexically_normal());
    return result.empty() ? folder : result;
}

/// Sorts by position, with problems of the document first.
void sortProblems(Diagnostics& problems, const std::string& document) {
    const auto position = [&](const Diagnostic& d) {
        return std::make_tuple(d.file != document, d.file, d.line, d.column);
    };
    std::stable_sort(problems.begin(), problems.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return position(a) < position(b); });
}

} // namespace

void readDocument(std::istream& input, const ForestFileOptions& options, ForestReading& reading) {
    const auto keepAlive = MapProgram::shared();
    reading.log.file = options.file;
    reading.log.settings = options.settings;
    reading.trees.maxCount = options.maxTrees;
    reading.forest.folder = absolute(options.folder);
    reading.folders = InputFolders(reading.forest.folder);
    auto text = readText(input, options.file);
    if (!text.ok())
        return reading.log.add(text.problems().front());
    reading.forest.source = std::move(text.value());
    TableReader::readDocument(reading.forest.source, reading.log,
                              [&](TableReader& root) { readRoot(root, reading); });
    reading.forest.notes = std::move(reading.log.notes);
    if (!options.settings.empty())
        reading.forest.source.clear(); // it does not describe the forest with the settings
    sortProblems(reading.log.problems, options.file);
}

void readDocumentFile(const std::string& path, std::size_t maxTrees, const std::vector<std::string>& settings,
                      ForestReading& reading) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return reading.log.add(input.problems().front());
    readDocument(input.value(), {path, folderOf(path), maxTrees, settings}, reading);
}

namespace {

Result<ForestFile> takeResult(ForestReading& reading) {
    if (reading.log.problems.empty())
        return std::move(reading.forest);
    return std::move(reading.log.problems);
}

} // namespace

Result<ForestFile> readForest(std::istream& input, const ForestFileOptions& options) {
    ForestReading reading;
    readDocument(input, options, reading);
    return takeResult(reading);
}

Result<ForestFile> readForestFile(const std::string& path, std::size_t maxTrees,
                                  const std::vector<std::string>& settings) {
    ForestReading reading;
    readDocumentFile(path, maxTrees, settings, reading);
    return takeResult(reading);
}

} // namespace osgTreeWind
