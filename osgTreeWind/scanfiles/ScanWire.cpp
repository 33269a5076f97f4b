// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanWire.h>

#include <osgTreeWind/base/Wire.h>

namespace osgTreeWind {

namespace {

bool passScan(Wire& wire, ScanFile& scan) {
    return wire.pass(scan.format) && wire.pass(scan.trees);
}

} // namespace

bool ScanWire::send(int descriptor, Result<ScanFile>& scan) {
    return Wire::send(descriptor, scan, passScan);
}

std::optional<Result<ScanFile>> ScanWire::receive(int descriptor) {
    return Wire::receive(descriptor, passScan);
}

} // namespace osgTreeWind
