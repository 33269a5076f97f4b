// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/scanfiles/ScanColumns.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanRows.h>
#include <osgTreeWind/system/Path.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

namespace osgTreeWind {
namespace {

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// Whether these are the columns of TreeQSM in their order.
bool isTreeQsmHeader(const std::vector<std::string_view>& names) {
    constexpr const char* order[] = {"radius", "length", "start", "start", "start",
                                     "axis",   "axis",   "axis",  "parent"};
    for (std::size_t i = 0; i < std::size(order); ++i)
        if (i >= names.size() || !contains(lower(std::string(names[i])), order[i]))
            return false;
    return names.size() == 15 || names.size() == 17;
}

using Reader = Result<ScanFile> (*)(std::string_view, const std::string&);

/// The reader for the format of the first line; null if it is unknown.
Reader findReader(ScanRows rows) {
    const std::vector<std::string_view> words = rows.words();
    if (parseNumber(words.front()))
        return words.size() > 9 ? readTreeQsm : readSwc;
    std::string line;
    for (const std::string_view word : words)
        line += lower(std::string(word)) + ' ';
    const std::size_t segment = line.find("x y z radius ");
    const bool hasSeveralInALine =
        segment != std::string::npos && (line.find("x y z radius ", segment + 1) != std::string::npos ||
                                         !rows.next() || rows.words().size() > words.size());
    if (hasSeveralInALine && contains(line, "parent_id "))
        return readRayCloudTree;
    const bool havePlaces = ScanColumns::havePlaces(line),
               areTreeQsms = contains(line, "radius") && contains(line, "axis") && contains(line, "parent");
    if (isTreeQsmHeader(words) || (areTreeQsms && !havePlaces))
        return readTreeQsm;
    return havePlaces || ScanColumns::haveRadii(line) ? readScanTable : nullptr;
}

double cylinderVolume(const ScanCylinder& cylinder) {
    return glm::pi<double>() * cylinder.radius * cylinder.radius *
           glm::distance(cylinder.start, cylinder.end);
}

/// Distance from a point to the bark of a cylinder.
double barkDistance(const ScanCylinder& cylinder, const glm::dvec3& point) {
    const glm::dvec3 axis = cylinder.end - cylinder.start;
    const double along =
        glm::clamp(glm::dot(point - cylinder.start, axis) / std::max(glm::dot(axis, axis), 1e-12), 0.0, 1.0);
    return std::abs(glm::distance(point, cylinder.start + along * axis) - cylinder.radius);
}

/// The cylinder without a parent at the start of each cylinder's branch; -1 in a loop or with a missing
/// parent.
std::vector<int> findRoots(const ScanCylinders& cylinders) {
    constexpr int unknown = -2;
    const int count = static_cast<int>(cylinders.size());
    std::vector<int> roots(cylinders.size(), unknown), path;
    for (int i = 0; i < count; ++i) {
        int at = i;
        for (path.clear(); at >= 0 && at < count && roots[static_cast<std::size_t>(at)] == unknown;
             at = cylinders[static_cast<std::size_t>(at)].parent) {
            roots[static_cast<std::size_t>(at)] = -1; // it stays -1 in a loop
            path.push_back(at);
        }
        const int root = at >= 0 && at < count       ? roots[static_cast<std::size_t>(at)]
                         : at == -1 && !path.empty() ? path.back()
                                                     : -1;
        for (const int each : path)
            roots[static_cast<std::size_t>(each)] = root;
    }
    return roots;
}

/// Joins each branch without a parent to the cylinder nearest to its start, because programs leave a few
/// twigs of a scan without a parent. The root is the cylinder without a parent that bears the most wood.
/// If the file has no parents, a branch may join another one that is joined later.
/// @param hasParents as ScanFile::hasParents. @return the number of joined branches; an error if they have
/// more than 5 % of the wood, or if the file has no parents and one is farther from the wood than its length.
Result<std::size_t> joinOrphans(ScanCylinders& cylinders, bool hasParents) {
    constexpr double maxComparisons = 2e9; // a few seconds
    const auto orphans =
        std::count_if(cylinders.begin(), cylinders.end(), [](const auto& each) { return each.parent == -1; });
    if (orphans < 2)
        return std::size_t(0);
    if (static_cast<double>(orphans) * static_cast<double>(cylinders.size()) > maxComparisons)
        return fileProblem({}, "expected fewer branches without a parent, found " + std::to_string(orphans));
    const std::vector<int> roots = findRoots(cylinders);
    std::vector<double> volumes(cylinders.size(), 0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        if (roots[i] >= 0) {
            volumes[static_cast<std::size_t>(roots[i])] += cylinderVolume(cylinders[i]);
            all += cylinderVolume(cylinders[i]);
        }
    const auto trunk = std::max_element(volumes.begin(), volumes.end()) - volumes.begin();
    const auto root = static_cast<std::size_t>(trunk);
    constexpr double maxOrphanShare = 0.05;
    std::size_t joined = 0;
    std::vector<std::size_t> owners(cylinders.size()); // the root that each root is joined to, or itself
    std::iota(owners.begin(), owners.end(), std::size_t(0));
    const auto ownerOf = [&](int rootOfBranch) {
        auto at = static_cast<std::size_t>(rootOfBranch);
        while (owners[at] != at)
            at = owners[at] = owners[owners[at]];
        return at;
    };
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        if (cylinders[i].parent != -1 || i == root)
            continue;
        if (hasParents && !(all - volumes[root] <= maxOrphanShare * all)) // also if a volume is NaN
            return fileProblem({},
                               "expected one root, found a second one besides line " +
                                   std::to_string(cylinders[root].line) +
                                   "; branches without a parent have " +
                                   numberText(std::round(1000.0 * (1.0 - volumes[root] / all)) / 10.0) +
                                   " % of the wood, and at most 5 % can be joined to the nearest cylinder",
                               cylinders[i].line);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < cylinders.size(); ++other)
            if (roots[other] >= 0 &&
                (hasParents ? roots[other] == static_cast<int>(trunk) : ownerOf(roots[other]) != i))
                if (const double distance = barkDistance(cylinders[other], cylinders[i].start);
                    distance < nearest) {
                    nearest = distance;
                    cylinders[i].parent = static_cast<int>(other);
                }
        if (!hasParents && !(nearest <= glm::distance(cylinders[i].start, cylinders[i].end)))
            return fileProblem(
                {},
                "expected a cylinder that starts at the end of another or near it, found one " +
                    numberText(std::round(1000.0 * nearest) / 1000.0) +
                    " m from the nearest wood; a column of parents would join them",
                cylinders[i].line);
        if (!hasParents)
            owners[i] = ownerOf(roots[static_cast<std::size_t>(cylinders[i].parent)]);
        ++joined;
    }
    return joined;
}

/// From the foot of a tree to the middle of its wood.
glm::dvec3 lean(const ScanCylinders& cylinders) {
    glm::dvec3 sum(0.0), foot(0.0);
    double all = 0.0;
    for (const ScanCylinder& cylinder : cylinders) {
        if (cylinder.parent == -1)
            foot = cylinder.start;
        sum += cylinderVolume(cylinder) * 0.5 * (cylinder.start + cylinder.end);
        all += cylinderVolume(cylinder);
    }
    return sum / all - foot;
}

/// Turns trees whose y axis points up.
void turnUp(ScanFile& scan, ScanUp up) {
    glm::dvec3 middle(0.0);
    for (const ScanCylinders& tree : scan.trees)
        middle += lean(tree);
    const bool liesAlongY = middle.y > 2.0 * std::max(std::abs(middle.x), std::abs(middle.z));
    if (up == ScanUp::Z || (up == ScanUp::Found && !liesAlongY))
        return;
    if (up == ScanUp::Found)
        scan.notes.emplace_back(
            "y is taken as up, because the trees lie along it; up = \"z\" would keep them so");
    for (ScanCylinders& tree : scan.trees)
        for (ScanCylinder& cylinder : tree)
            for (glm::dvec3* place : {&cylinder.start, &cylinder.end})
                *place = {place->x, -place->z, place->y};
}

} // namespace

std::optional<Diagnostic> joinAndCheckTrees(ScanFile& scan, ScanUp up) {
    std::vector<Result<std::size_t>> counts;
    for (ScanCylinders& tree : scan.trees)
        counts.push_back(joinOrphans(tree, scan.hasParents));
    turnUp(scan, up);
    for (ScanCylinders& tree : scan.trees) {
        const Result<std::size_t>& joined = counts[static_cast<std::size_t>(&tree - scan.trees.data())];
        auto problem = joined ? problemOfScan(tree) : joined.problems().front();
        if (problem) {
            if (scan.trees.size() > 1)
                problem->key = "tree " + std::to_string(&tree - scan.trees.data() + 1);
            return problem;
        }
        scan.joined.push_back(joined.value());
    }
    return std::nullopt;
}

Result<ScanFile> readScan(std::string_view text, const std::string& file, ScanUp up) {
    ScanRows rows(text, file);
    if (!rows.next())
        return fileProblem(file, "expected a scanned tree, found only blank lines and comments");
    const Reader reader = findReader(rows);
    if (!reader)
        return fileProblem(
            file,
            "expected a scanned tree: TreeQSM's cylinders as text or .mat, a table of cylinders or points "
            "with named columns, a tree file of RayCloudTools, or SWC");
    Result<ScanFile> scan = reader(text, file);
    if (!scan)
        return scan;
    if (auto problem = joinAndCheckTrees(scan.value(), up)) {
        problem->file = file;
        return std::move(*problem);
    }
    return scan;
}

Result<ScanFile> readScanFile(const std::string& path, ScanUp up) {
    Result<std::ifstream> input = openInput(path);
    if (!input)
        return input.problems();
    std::error_code error;
    if (std::filesystem::file_size(toPath(path), error) > maxScanBytes && !error)
        return fileProblem(path, "expected at most " + std::to_string(maxScanBytes) + " bytes");
    if (isMatlab(readHead(input.value(), 128)))
        return readMatlab(path, up);
    const Result<std::string> text = readTextFile(path);
    if (!text)
        return text.problems();
    return readScan(text.value(), path, up);
}

} // namespace osgTreeWind
