// SPDX-License-Identifier: MIT
#include <tests/fuzz/Readers.h>

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Requires that the result is an error with a message, or trees with valid parents whose skeletons are
/// finite.
template <auto read, auto... up>
void readTrees(const std::string& bytes) {
    const Result<ScanFile> scan = read(bytes, "fuzz", up...);
    if (!isRead(scan))
        return;
    for (const ScanCylinders& cylinders : scan.value().trees) {
        for (const ScanCylinder& cylinder : cylinders)
            require(cylinder.parent >= -1 && cylinder.parent < static_cast<int>(cylinders.size()));
        const auto tree = makeScannedTree(cylinders);
        if (!tree)
            continue;
        for (const glm::vec3& point : tree.value().skeleton.points)
            require(std::isfinite(point.x + point.y + point.z));
        for (const BranchUnit& unit : tree.value().skeleton.units)
            require(unit.tipRadius > 0.0f && unit.baseRadius >= unit.tipRadius && unit.attach > 0.0f);
    }
}

const FuzzReaders scanReaders = {{"Scan", readTrees<readScan, ScanUp::Found>},
                                 {"ScanRayCloud", readTrees<readRayCloudTree>},
                                 {"ScanSwc", readTrees<readSwc>},
                                 {"ScanTable", readTrees<readScanTable>},
                                 {"ScanTreeQsm", readTrees<readTreeQsm>}};

} // namespace

} // namespace osgTreeWind
