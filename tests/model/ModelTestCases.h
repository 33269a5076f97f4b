// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/RecursiveTree.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace osgTreeWind {

template <typename Parameters>
struct Named {
    std::string name;
    Parameters parameters;
};
using NamedParameters = Named<RecursiveTreeParameters>;

/// The tree of §2.2 without random variation.
inline RecursiveTreeParameters regularTree() {
    RecursiveTreeParameters p;
    p.jitter = p.crook = p.follow = p.leader = 0.0f;
    p.length = 2.4f;
    p.boughLength = 0.36f;
    p.lengthRatio = 0.72f;
    p.inclination = 0.6f;
    p.inclinationGrowth = 1.25f;
    p.radius = 0.17f;
    return p;
}

/// Parameters at and beyond the limits of their ranges, all of which must make a valid tree.
inline std::vector<NamedParameters> extremeTrees() {
    std::vector<NamedParameters> cases;
    const auto add = [&](const char* name, auto change) {
        cases.push_back({name, {}});
        change(cases.back().parameters);
    };
    using P = RecursiveTreeParameters;
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    add("reference", [](P&) {});
    add("bare pole", [](P& p) { p.levels = -5, p.trunkUnits = -1, p.ringsPerBranch = 0; });
    add("levels 99", [](P& p) { p.levels = 99, p.childrenPerBranch = 2; });
    add("one child", [](P& p) { p.levels = 8, p.childrenPerBranch = -7, p.ringsPerBranch = 64; });
    add("tiny twigs", [](P& p) {
        p.levels = 8, p.childrenPerBranch = 2, p.lengthRatio = 0.0f, p.taper = 0.0f, p.radiusRatio = 0.0f;
        p.jitter = 1.0f, p.crook = 0.3f;
    });
    add("giant", [](P& p) {
        p.levels = 6, p.childrenPerBranch = 3, p.length = 1e30f, p.lengthRatio = 1e30f, p.radius = 0.0f;
        p.trunkUnits = 16, p.jitter = 1.0f;
    });
    add("fat", [](P& p) { p.radius = 1e30f, p.taper = p.radiusRatio = 1.0f, p.lengthRatio = 0.0f; });
    add("crooked", [](P& p) { p.crook = 0.3f, p.ringsPerBranch = 64, p.jitter = 1.0f; });
    add("three crooked rings", [](P& p) { p.crook = 0.3f, p.ringsPerBranch = 3, p.jitter = 1.0f; });
    add("hanging", [](P& p) { p.inclination = 9.0f, p.inclinationGrowth = 9.0f, p.follow = 0.5f; });
    add("stump without a radius", [nan](P& p) { p.length = 0.01f, p.trunkUnits = 1, p.radius = nan; });
    add("conifer", [](P& p) {
        p.trunkUnits = 16, p.bareUnits = -4, p.levels = 2, p.childrenPerBranch = 8, p.leader = 9.0f;
        p.crownTaper = 0.0f, p.boughLength = 9.0f, p.jitter = 1.0f;
    });
    add("all NaN", [nan](P& p) {
        p.length = p.lengthRatio = p.inclination = p.inclinationGrowth = p.follow = nan;
        p.twist = p.jitter = p.crook = p.radius = p.taper = p.radiusRatio = nan;
    });
    for (const float value : {inf, -inf, -1e30f})
        add(value > 0 ? "all infinite" : "all negative", [value](P& p) {
            p.length = p.lengthRatio = p.inclination = p.inclinationGrowth = p.follow = value;
            p.twist = p.jitter = p.crook = p.radius = p.taper = p.radiusRatio = value;
        });
    return cases;
}

inline bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// FNV-1a hash of the bits of points.
inline std::uint64_t fingerprint(const std::vector<glm::vec3>& points) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const glm::vec3& point : points)
        for (int axis = 0; axis < 3; ++axis) {
            std::uint32_t bits = 0;
            const float value = point[axis];
            std::memcpy(&bits, &value, sizeof bits);
            for (int shift = 0; shift < 32; shift += 8)
                hash = (hash ^ ((bits >> shift) & 0xffu)) * 0x100000001b3ull;
        }
    return hash;
}

} // namespace osgTreeWind
