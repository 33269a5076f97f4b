// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzScan.h>

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/scanfiles/ScanFile.h>

#include <sys/mman.h>
#include <unistd.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const int file = memfd_create("fuzz", 0);
    if (write(file, data, size) == static_cast<ssize_t>(size) && lseek(file, 0, SEEK_SET) == 0) {
        const auto scan = Wire::receive<ScanFile>(file);
        if (scan && scan->ok())
            for (const ScanCylinders& tree : scan->value().trees)
                if (!problemOfScan(tree))
                    (void)makeScannedTree(tree);
    }
    close(file);
    return 0;
}
