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

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// Whether these are the names of TreeQSM's columns, all and in its order.
bool isOrderOfTreeQsm(const std::vector<std::string_view>& names) {
    constexpr const char* order[] = {"radius", "length", "start", "start", "start",
                                     "axis",   "axis",   "axis",  "parent"};
    for (std::size_t i = 0; i < std::size(order); ++i)
        if (i >= names.size() || !has(lower(std::string(names[i])), order[i]))
            return false;
    return names.size() == 15 || names.size() == 17;
}

using Reader = Result<ScanFile> (*)(std::string_view, const std::string&);

/// The reader of the format that the first line is in; null for none.
Reader readerOf(const ScanRows& rows) {
    std::string line; // its words
    for (const std::string_view word : rows.words())
        line += lower(std::string(word)) + ' ';
    if (ScanColumns::knows(line) && !isOrderOfTreeQsm(rows.words()))
        return readScanTable;
    if (has(line, "x y z radius "))
        return readRayCloudTree;
    if (has(line, "radius") && has(line, "axis") && has(line, "parent"))
        return readTreeQsm;
    if (!parseNumber(rows.words().front()))
        return nullptr;
    return rows.words().size() > 9 ? readTreeQsm : readSwc;
}

/// The first bytes of a file.
std::string headOf(const std::string& path) {
    std::string head(128, '\0');
    std::ifstream input(path, std::ios::binary);
    input.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(input.gcount()));
    return head;
}

} // namespace

std::optional<Diagnostic> settleTrees(ScanFile& scan) {
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
    const Reader reader = readerOf(rows);
    if (!reader) // of what it is instead nothing is told
        return fileProblem(
            file, "expected a scanned tree: TreeQSM's cylinders as text or .mat, a table of SimpleForest, "
                  "aRchi or rTwig, a tree file of RayCloudTools, or SWC");
    Result<ScanFile> scan = reader(text, file);
    if (!scan)
        return scan;
    if (auto problem = settleTrees(scan.value())) {
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
    if (isMatlab(headOf(path)))
        return readMatlab(path);
    const Result<std::string> text = readTextFile(path);
    if (!text)
        return text.problems();
    return readScan(text.value(), path);
}

} // namespace osgTreeWind
