// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestMemory.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {
namespace {

/// Of a simulation: what one unit, or cluster of leaves, adds to its arrays.
constexpr std::uint64_t unitBytes = sizeof(WindPlace) + sizeof(glm::vec3) + 2 * sizeof(glm::vec4) +
                                    sizeof(glm::quat) + sizeof(UnitPose) + sizeof(Laws::ThesisBranch);
constexpr std::uint64_t leafBytes = sizeof(glm::vec4);

// Of nodes, measured: a tree with its uniforms and drawables, and the texels of its units and leaves, which
// the graphics driver may hold once more.
// Under `modal` a tree stands in a cell and, if drawn, in lists of two frames with what its pose is made of.
constexpr std::uint64_t instanceBytes = 1000, posesInTexture = 4096,
                        unitPoseBytes = 2 * 4 * sizeof(glm::vec4), impostorBytes = 8000000;
constexpr std::uint64_t treeNodeBytes = 8000, unitTexelBytes = 2 * 32, leafTexelBytes = 2 * 16;

std::uint64_t shapeBytes(const TreeCounts& counts) {
    return counts.units * sizeof(BranchUnit) + counts.skeletonPoints * sizeof(glm::vec3) +
           counts.skinVertices * sizeof(SkinVertex) + 3 * counts.skinTriangles * sizeof(std::uint32_t) +
           counts.leafVertices / verticesPerLeafCluster * sizeof(LeafCluster);
}

/// "1.5 GB", three digits.
std::string bytesText(std::uint64_t bytes) {
    const char* units[] = {" bytes", " kB", " MB", " GB", " TB"};
    auto number = static_cast<double>(bytes);
    int unit = 0;
    for (; number >= 999.5 && unit < 4; ++unit)
        number /= 1000.0;
    const double step = number < 9.995 ? 0.01 : number < 99.95 ? 0.1 : 1.0;
    return numberText(std::round(std::round(number / step) * step * 100.0) / 100.0) + units[unit];
}

std::optional<std::uint64_t> environmentLimit() {
    const char* value = std::getenv("OSGTREEWIND_MAX_MEMORY");
    std::string text = value ? value : "";
    double unit = 1.0;
    const std::size_t suffix = std::string("kMGT").find(text.empty() ? ' ' : text.back());
    if (suffix != std::string::npos) {
        unit = std::pow(1000.0, static_cast<double>(suffix + 1));
        text.pop_back();
    }
    const std::optional<double> number = parseNumber(text);
    if (!number || *number < 0.0 || *number * unit >= 0x1p64)
        return std::nullopt;
    return static_cast<std::uint64_t>(*number * unit);
}

} // namespace

ForestMemory forestMemory(const ForestDescription& description) {
    const ShapeFamilies families(description);
    std::vector<std::uint64_t> trees(families.all().size(), 0);
    for (const TreePlacement& tree : description.trees)
        ++trees[families.indexOf(tree)];
    const bool modal = description.law == MotionLaw::Modal;
    const std::vector<TreeCounts> largest = families.countLargest();
    ForestMemory memory;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const auto shapes = std::uint64_t(families.all()[i].shapes);
        const TreeCounts& counts = largest[i];
        const std::uint64_t leaves = counts.leafVertices / verticesPerLeafCluster;
        memory.simulation +=
            shapes * shapeBytes(counts) +
            trees[i] * (modal ? simulatedTreeBytes(ModalLevel::Near)
                              : sizeof(PlacedTree) + counts.units * unitBytes + leaves * leafBytes);
        if (modal) // up to the finest tier once more in the coarser ones
            memory.nodes += trees[i] * instanceBytes +
                            shapes * (2 * geometryBytes(counts) + impostorBytes +
                                      std::min(trees[i], posesInTexture) * counts.units * unitPoseBytes);
        else
            memory.nodes +=
                shapes * geometryBytes(counts) +
                trees[i] * (treeNodeBytes + counts.units * unitTexelBytes + leaves * leafTexelBytes);
    }
    return memory;
}

std::uint64_t geometryBytes(const TreeCounts& counts) {
    constexpr std::uint64_t skinVertex = 40, leafVertex = 88, index = 4;
    return counts.skinVertices * skinVertex + counts.leafVertices * leafVertex +
           3 * index * counts.totalTriangles();
}

std::size_t simulatedTreeBytes(ModalLevel level) {
    return sizeof(PlacedTree) + ModalMotion::treeBytes(level);
}

std::uint64_t memoryLimit() {
    if (const auto limit = environmentLimit())
        return *limit;
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
    std::ifstream machine("/proc/meminfo");
    for (std::string key; machine >> key; machine.ignore(256, '\n'))
        if (std::uint64_t kilobytes = 0; key == "MemAvailable:" && machine >> kilobytes)
            limit = 1024 * kilobytes;
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) { // ulimit -v
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const std::uint64_t used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
        limit =
            std::min<std::uint64_t>(limit, space.rlim_cur - std::min<std::uint64_t>(used, space.rlim_cur));
    }
    return limit;
}

std::string problemOfMemory(const std::string& what, std::uint64_t bytes) {
    const std::uint64_t limit = memoryLimit();
    if (bytes <= limit)
        return {};
    return what + " need about " + bytesText(bytes) + " of memory; the limit is " + bytesText(limit) +
           " (OSGTREEWIND_MAX_MEMORY sets another)";
}

std::string problemOfMemory(const ForestDescription& description, bool withNodes) {
    const ForestMemory memory = forestMemory(description);
    return problemOfMemory(std::to_string(description.trees.size()) + " trees of these species",
                           memory.simulation + (withNodes ? memory.nodes : 0));
}

} // namespace osgTreeWind
