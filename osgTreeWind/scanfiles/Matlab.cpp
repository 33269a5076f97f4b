// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProcess.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

namespace osgTreeWind {

bool isMatlab(std::string_view head) {
    if (head.size() < 128)
        return false;
    const std::string_view end = head.substr(124, 4); // version and byte order
    return end == std::string_view("\0\1IM", 4) || end == std::string_view("\1\0MI", 4) ||
           end == std::string_view("\0\2IM", 4) || end == std::string_view("\2\0MI", 4);
}

Result<ScanFile> readMatlab(const std::string& path, ScanUp up) {
    Result<ScanFile> scan = readWithProgram<ScanFile>(
        {"osgtreewind-matlab", "OSGTREEWIND_MATLAB", ".mat", "libmatio"}, {path, "trees"});
    if (auto problem = scan ? joinAndCheckTrees(scan.value(), up) : std::nullopt) {
        const std::string tree = problem->key.empty() ? "tree 1" : problem->key;
        return Diagnostic{path, 0, 0,
                          problem->line > 0 ? tree + ", cylinder " + std::to_string(problem->line) : tree,
                          problem->message};
    }
    return scan;
}

} // namespace osgTreeWind
