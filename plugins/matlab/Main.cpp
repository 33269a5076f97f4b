// SPDX-License-Identifier: MIT
// osgtreewind-matlab FILE trees: reads a .mat file for the library in a separate process, because libmatio
// and libhdf5 crash on damaged files.
#include <plugins/ReaderLimits.h>
#include <plugins/matlab/MatFile.h>
#include <plugins/matlab/TreeQsmMat.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Program.h>

#include <iostream>
#include <new>

namespace osgTreeWind {

namespace {

std::string path;
int output = -1;

/// Exits without cleaning up, which could crash on damaged data.
[[noreturn]] void sendAndExit(Result<ScanFile> scan) {
    exitNow(Wire::send(output, scan) && finishOutput(output) ? 0 : 1);
}

void fail(const std::string& reason) {
    sendAndExit(fileProblem(path, "the .mat file is damaged: " + reason));
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    trustOwnLibraries();
    const std::vector<std::string> arguments = programArguments(argc, argv);
    if (arguments.size() != 3) {
        std::cerr << "usage: osgtreewind-matlab FILE trees\n"
                     "Reads .mat files for osgTreeWind. Its output is binary.\n";
        return 2;
    }
    path = arguments[1];
    output = takeStandardOutput();
    limitResources({path}, std::size_t(1) << 26, 10);
    try {
        sendAndExit(readTreeQsmMat(MatFile(path, fail), path));
    } catch (const std::bad_alloc&) {
        fail("out of memory");
    }
}
