// SPDX-License-Identifier: MIT
// osgtreewind-matlab FILE trees: reads .mat for the library, which runs it, so that a damaged file, on which
// libmatio and libhdf5 break, ends this process and not the one that has a forest.
#include <plugins/ReaderLimits.h>
#include <plugins/matlab/MatFile.h>
#include <plugins/matlab/TreeQsmMat.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>

#include <iostream>
#include <new>

#include <unistd.h>

namespace osgTreeWind {

namespace {

std::string path;

/// Ends this process at once: what was damaged is not tidied up.
[[noreturn]] void answer(Result<ScanFile> scan) {
    _exit(Wire::send(STDOUT_FILENO, scan) ? 0 : 1);
}

void fail(const std::string& reason) {
    answer(fileProblem(path, "the .mat file is damaged: " + reason));
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    if (argc != 3) {
        std::cerr << "usage: osgtreewind-matlab FILE trees\n"
                     "What osgTreeWind reads .mat with; its answer is not for people.\n";
        return 2;
    }
    path = argv[1];
    limitReader({path}, std::size_t(1) << 26, 10);
    try {
        answer(readTreeQsmMat(MatFile(path, fail), path));
    } catch (const std::bad_alloc&) {
        fail("no memory is left for it");
    }
}
