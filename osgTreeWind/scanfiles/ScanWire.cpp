// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanWire.h>

#include <osgTreeWind/base/Wire.h>

namespace osgTreeWind {

namespace {

bool pass(Wire& wire, ScanFile& scan) {
    return wire.pass(scan.format) && wire.pass(scan.trees);
}

} // namespace

bool ScanWire::send(int descriptor, Result<ScanFile>& scan) {
    return Wire::send(descriptor, scan, pass);
}

std::optional<Result<ScanFile>> ScanWire::receive(int descriptor) {
    return Wire::receive(descriptor, pass);
}

} // namespace osgTreeWind
