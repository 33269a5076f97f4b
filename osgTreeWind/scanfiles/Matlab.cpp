// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProcess.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

namespace osgTreeWind {

bool isMatlab(std::string_view head) {
    if (head.size() < 128)
        return false;
    const std::string_view end = head.substr(124, 4); // the version, and which of its bytes comes first
    return end == std::string_view("\0\1IM", 4) || end == std::string_view("\1\0MI", 4) ||
           end == std::string_view("\0\2IM", 4) || end == std::string_view("\2\0MI", 4);
}

Result<ScanFile> readMatlab(const std::string& path) {
    Result<ScanFile> scan =
        readBy<ScanFile>({"osgtreewind-matlab", "OSGTREEWIND_MATLAB", ".mat", "libmatio"}, {path, "trees"});
    for (std::size_t tree = 0; scan && tree < scan.value().trees.size(); ++tree)
        if (auto unsound = problemOfScan(scan.value().trees[tree])) {
            const std::string of = "tree " + std::to_string(tree + 1);
            return Diagnostic{path, 0, 0,
                              unsound->line > 0 ? of + ", cylinder " + std::to_string(unsound->line) : of,
                              unsound->message};
        }
    return scan;
}

} // namespace osgTreeWind
