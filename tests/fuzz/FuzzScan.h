// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

/// Entry point that libFuzzer calls; see script/fuzz.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace osgTreeWind {

/// Aborts unless the result is an error with a message, or trees with valid parents whose skeletons are
/// finite.
inline void expectErrorOrTrees(const Result<ScanFile>& scan) {
    if (!scan) {
        if (scan.problems().empty() || scan.problems().front().message.empty())
            std::abort();
        return;
    }
    for (const ScanCylinders& cylinders : scan.value().trees) {
        for (const ScanCylinder& cylinder : cylinders)
            if (cylinder.parent < -1 || cylinder.parent >= static_cast<int>(cylinders.size()))
                std::abort();
        const auto tree = makeScannedTree(cylinders);
        if (!tree)
            continue;
        for (const glm::vec3& point : tree.value().skeleton.points)
            if (!std::isfinite(point.x + point.y + point.z))
                std::abort();
        for (const BranchUnit& unit : tree.value().skeleton.units)
            if (!(unit.tipRadius > 0.0f && unit.baseRadius >= unit.tipRadius && unit.attach > 0.0f))
                std::abort();
    }
}

} // namespace osgTreeWind
