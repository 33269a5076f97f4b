// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/scanfiles/ScanColumns.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanOrphans.h>
#include <osgTreeWind/scanfiles/ScanRows.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace osgTreeWind {

namespace {

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// Whether these are the columns of TreeQSM in their order.
bool isTreeQsmHeader(const std::vector<std::string_view>& names) {
    constexpr const char* order[] = {"radius", "length", "start", "start", "start",
                                     "axis",   "axis",   "axis",  "parent"};
    for (std::size_t i = 0; i < std::size(order); ++i)
        if (i >= names.size() || !contains(lower(std::string(names[i])), order[i]))
            return false;
    return names.size() == 15 || names.size() == 17;
}

using Reader = Result<ScanFile> (*)(std::string_view, const std::string&);

/// The reader for the format of the first line; null if it is unknown.
Reader findReader(const ScanRows& rows) {
    std::string line; // its words
    for (const std::string_view word : rows.words())
        line += lower(std::string(word)) + ' ';
    if (ScanColumns::matches(line) && !isTreeQsmHeader(rows.words()))
        return readScanTable;
    if (contains(line, "x y z radius "))
        return readRayCloudTree;
    if (contains(line, "radius") && contains(line, "axis") && contains(line, "parent"))
        return readTreeQsm;
    if (!parseNumber(rows.words().front()))
        return nullptr;
    return rows.words().size() > 9 ? readTreeQsm : readSwc;
}

/// The first bytes of a file.
std::string readHead(const std::string& path) {
    std::string head(128, '\0');
    std::ifstream input(path, std::ios::binary);
    input.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(input.gcount()));
    return head;
}

} // namespace

std::optional<Diagnostic> joinAndCheckTrees(ScanFile& scan) {
    for (ScanCylinders& tree : scan.trees) {
        const Result<std::size_t> joined = joinOrphans(tree);
        auto problem = joined ? problemOfScan(tree) : joined.problems().front();
        if (problem) {
            if (scan.trees.size() > 1)
                problem->key = "tree " + std::to_string(&tree - scan.trees.data() + 1);
            return problem;
        }
        scan.joined.push_back(joined.value());
    }
    return std::nullopt;
}

Result<ScanFile> readScan(std::string_view text, const std::string& file) {
    ScanRows rows(text, file);
    if (!rows.next())
        return fileProblem(file, "expected a scanned tree, found only blank lines and comments");
    const Reader reader = findReader(rows);
    if (!reader)
        return fileProblem(
            file, "expected a scanned tree: TreeQSM's cylinders as text or .mat, a table of SimpleForest, "
                  "aRchi or rTwig, a tree file of RayCloudTools, or SWC");
    Result<ScanFile> scan = reader(text, file);
    if (!scan)
        return scan;
    if (auto problem = joinAndCheckTrees(scan.value())) {
        problem->file = file;
        return std::move(*problem);
    }
    return scan;
}

Result<ScanFile> readScanFile(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    std::error_code error;
    if (std::filesystem::file_size(path, error) > maxScanBytes && !error)
        return fileProblem(path, "expected at most " + std::to_string(maxScanBytes) + " bytes");
    if (isMatlab(readHead(path)))
        return readMatlab(path);
    const Result<std::string> text = readTextFile(path);
    if (!text)
        return text.problems();
    return readScan(text.value(), path);
}

} // namespace osgTreeWind
