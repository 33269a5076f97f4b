// SPDX-License-Identifier: MIT
// What the library receives from its reader programs.
#include <tests/fuzz/Readers.h>

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <sys/mman.h>

namespace osgTreeWind {

namespace {

/// @param use is called with what was received, if it is a value.
template <typename T>
void receive(const std::string& bytes, void (*use)(const T& value)) {
    const int file = memfd_create("fuzz", 0);
    require(write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
    lseek(file, 0, SEEK_SET);
    if (const auto received = Wire::receive<T>(file); received && received->ok())
        use(received->value());
    close(file);
}

void receiveWind(const std::string& bytes) {
    receive<WindContent>(bytes, [](const WindContent& content) {
        static_cast<void>(GridWind::check(std::get<GridWind::Grid>(content.data)));
    });
}

void receiveScan(const std::string& bytes) {
    receive<ScanFile>(bytes, [](const ScanFile& scan) {
        for (const ScanCylinders& tree : scan.trees)
            if (!problemOfScan(tree))
                static_cast<void>(makeScannedTree(tree));
    });
}

const FuzzReaders wireReaders = {{"WindWire", receiveWind}, {"ScanWire", receiveScan}};

} // namespace

} // namespace osgTreeWind
