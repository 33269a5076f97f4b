// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/ScannedTree.h>

#include <osgTreeWind/model/AxesSkeleton.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/ScanAxes.h>
#include <osgTreeWind/model/WoodVolume.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

Result<ScannedTree> makeScannedTree(const ScanCylinders& cylinders, const WoodDetail& detail) {
    if (auto problem = problemOfScan(cylinders))
        return std::move(*problem);
    std::vector<WoodAxis> axes = axesOfScan(cylinders);
    ScannedTree tree;
    ScanReport& report = tree.report;
    for (const WoodAxis& axis : axes) {
        report.cylinders += axis.pieces;
        report.cylinderVolume += axis.volume;
        for (const glm::dvec3& point : axis.line.points)
            report.height = std::max(report.height, point.z);
    }
    AxesSkeleton made = makeSkeleton(std::move(axes), detail);
    tree.skeleton = std::move(made.skeleton);
    report.usedCylinders = made.pieces;
    report.units = tree.skeleton.units.size();
    report.shoots = tree.skeleton.shoots.size();
    report.woodVolume = woodVolume(tree.skeleton);
    report.baseDiameter = 2.0 * static_cast<double>(tree.skeleton.units.front().baseRadius);
    return tree;
}

} // namespace osgTreeWind
