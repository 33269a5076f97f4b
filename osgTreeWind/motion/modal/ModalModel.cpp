// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalModel.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/modal/DragPatches.h>
#include <osgTreeWind/motion/modal/TreeModes.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace osgTreeWind {

namespace {

constexpr std::size_t candidates = 32;
constexpr std::size_t fewestModes = 8;
constexpr double enoughEnergy = 0.95;

/// Generalized force on each joint of unit forces x, y, z on a patch, distributed over the patch by its drag.
using PatchTorques = std::vector<std::vector<glm::dvec3>>; // per patch and joint

struct Patches {
    std::vector<std::size_t> ofLink;
    std::vector<ModalModel::Patch> list;
    PatchTorques torques;
};

Patches makePatches(const JointTree& tree, const ModalMaterial& material, std::size_t count) {
    std::vector<std::size_t> ofLink = dragPatches(tree, count);
    std::size_t made = 0;
    for (const std::size_t patch : ofLink)
        made = std::max(made, patch + 1);
    std::vector<double> area(made), wood(made), leaves(made), still(made);
    std::vector<glm::dvec3> place(made, glm::dvec3(0.0));
    Patches patches{{},
                    std::vector<ModalModel::Patch>(made),
                    PatchTorques(made, std::vector<glm::dvec3>(tree.jointCount(), glm::dvec3(0.0)))};
    for (const JointTree::Point& point : tree.points) {
        const std::size_t p = ofLink[point.link];
        const double drag = point.woodDrag + point.leafDrag;
        area[p] += drag;
        wood[p] += point.woodDrag;
        leaves[p] += point.leafDrag;
        still[p] += point.stillDrag;
        place[p] += drag * point.place;
    }
    for (const JointTree::Point& point : tree.points) {
        const std::size_t p = ofLink[point.link];
        const double drag = point.woodDrag + point.leafDrag;
        if (!(drag > 0.0))
            continue;
        for (int c = static_cast<int>(point.link); c >= 0; c = tree.links[static_cast<std::size_t>(c)].parent)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto carrier = static_cast<std::size_t>(c);
                patches.torques[p][2 * carrier + axis] +=
                    drag / area[p] * tree.displacement(point, carrier, axis);
            }
    }
    for (std::size_t p = 0; p < made; ++p) {
        ModalModel::Patch& patch = patches.list[p];
        const double half = 0.5 * airDensity;
        patch.place = area[p] > 0.0 ? place[p] / area[p] : glm::dvec3(0.0);
        patch.woodDrag = static_cast<float>(half * wood[p]);
        patch.leafDrag = static_cast<float>(half * leaves[p]);
        patch.stillDrag = static_cast<float>(half * still[p]);
        const auto foliage = area[p] > 0.0 ? static_cast<float>(leaves[p] / area[p]) : 0.0f;
        patch.streamlining = foliage * material.streamlining;
        patch.breezeStreamlining = foliage * material.breezeStreamlining;
    }
    patches.ofLink = std::move(ofLink);
    return patches;
}

glm::dvec3 lever(const TreeMode& mode, const std::vector<glm::dvec3>& torques) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < torques.size(); ++i)
        sum += mode.angles[i] * torques[i];
    return sum;
}

/// Squared response to horizontal gusts of equal strength at all patches, half of them common to the whole
/// crown.
/// @param leverOf lever of a patch.
template <typename LeverOf>
double squareUnderGusts(const Patches& patches, const LeverOf& leverOf) {
    double alone = 0.0;
    glm::dvec3 together(0.0);
    for (std::size_t p = 0; p < patches.list.size(); ++p) {
        const ModalModel::Patch& patch = patches.list[p];
        const glm::dvec3 force = static_cast<double>(patch.woodDrag + patch.leafDrag) * leverOf(p);
        alone += force.x * force.x + force.y * force.y;
        together += force;
    }
    return alone + together.x * together.x + together.y * together.y;
}

/// Static energy of a mode under gusts.
double energyUnderGusts(const TreeMode& mode, const Patches& patches) {
    return squareUnderGusts(patches, [&](std::size_t p) { return lever(mode, patches.torques[p]); }) /
           (mode.omega * mode.omega);
}

/// Sorts modes by the energy with which gusts excite them: low frequencies meet more of the gust spectrum,
/// whose power falls as f^-5/3.
std::vector<std::size_t> sortedByEnergy(const std::vector<TreeMode>& modes,
                                        const std::vector<double>& energies) {
    std::vector<std::size_t> order(modes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto swing = [&](std::size_t k) { return energies[k] * math::pow(modes[k].omega, -2.0 / 3.0); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return swing(a) > swing(b); });
    return order;
}

/// Static energy of all modes, including those that are not kept.
double totalEnergy(const JointTree& tree, const Patches& patches) {
    double energy = 0.0;
    for (std::size_t i = 0; i < tree.jointCount(); ++i)
        energy += squareUnderGusts(patches, [&](std::size_t p) { return patches.torques[p][i]; }) /
                  tree.links[i / 2].stiffness;
    return energy;
}

/// Builds a model with these modes.
ModalModel buildModel(const JointTree& tree, const ModalMaterial& material,
                      const std::vector<TreeMode>& modes, const std::vector<double>& shares,
                      const Patches& patches) {
    ModalModel model;
    const std::size_t joints = tree.jointCount(), count = modes.size(), patchCount = patches.list.size();
    model.joints = joints;
    model.patches = patches.list;
    model.patchOfLink = patches.ofLink;
    model.dampingRatio = material.dampingRatio;
    model.streamlinedTo = std::max(material.streamlinedTo, 10.0f);
    model.maxAngle = material.maxAngle;
    std::vector<std::vector<glm::dvec3>> levers(patchCount); // per patch and mode
    for (std::size_t p = 0; p < patchCount; ++p)
        for (const TreeMode& mode : modes)
            levers[p].push_back(lever(mode, patches.torques[p]));

    for (std::size_t k = 0; k < count; ++k) {
        ModalModel::Mode mode;
        mode.omega = static_cast<float>(modes[k].omega);
        mode.weightShare = static_cast<float>(modes[k].weightShare);
        mode.energyShare = static_cast<float>(shares[k]);
        double square = 1e-18; // mean of the squared joint angles, weighted by elastic energy
        for (std::size_t i = 0; i < joints; ++i) {
            const double angle = modes[k].angles[i] * modes[k].angles[i];
            square += angle * angle * tree.links[i / 2].stiffness / (modes[k].omega * modes[k].omega);
        }
        mode.limit = static_cast<float>(10.0 * static_cast<double>(material.maxAngle) / std::sqrt(square));
        model.modes.push_back(mode);
    }
    for (std::size_t p = 0; p < patchCount; ++p) {
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < count; ++k)
                model.levers.push_back(static_cast<float>(levers[p][k][axis]));
        for (std::size_t k = 0; k < count; ++k)
            model.brakes.push_back(static_cast<float>(glm::dot(levers[p][k], levers[p][k])));
    }
    model.poses.reserve(joints * model.columns());
    for (std::size_t i = 0; i < joints; ++i) {
        for (const TreeMode& mode : modes)
            model.poses.push_back(static_cast<float>(mode.angles[i]));
        for (std::size_t p = 0; p < patchCount; ++p) {
            glm::dvec3 rest = patches.torques[p][i] / tree.links[i / 2].stiffness;
            for (std::size_t k = 0; k < count; ++k)
                rest -= modes[k].angles[i] / (modes[k].omega * modes[k].omega) * levers[p][k];
            for (int axis = 0; axis < 3; ++axis)
                model.poses.push_back(static_cast<float>(rest[axis]));
        }
    }
    return model;
}

} // namespace

std::vector<ModalModel> makeModalModels(const JointTree& tree, const ModalMaterial& material,
                                        const std::vector<ModalDetail>& details) {
    std::vector<ModalModel> models;
    std::vector<TreeMode> modes; // kept at the finest detail, in order of energy
    std::vector<double> shares;
    for (const ModalDetail& detail : details) {
        const Patches patches =
            makePatches(tree, material, std::clamp<std::size_t>(detail.patches, 1, ModalDetail::maxPatches));
        const std::size_t most = std::clamp<std::size_t>(detail.modes, 1, ModalDetail::maxModes);
        if (models.empty()) {
            const std::vector<TreeMode> found = lowestModes(tree, candidates);
            std::vector<double> energies;
            for (const TreeMode& mode : found)
                energies.push_back(energyUnderGusts(mode, patches));
            const double whole = totalEnergy(tree, patches);
            double kept = 0.0;
            for (const std::size_t k : sortedByEnergy(found, energies)) {
                if (modes.size() == most || (modes.size() >= fewestModes && kept >= enoughEnergy))
                    break;
                modes.push_back(found[k]);
                shares.push_back(whole > 0.0 ? energies[k] / whole : 0.0);
                kept += shares.back();
            }
        }
        const std::size_t count = std::min(most, modes.size());
        models.push_back(buildModel(tree, material,
                                    {modes.begin(), modes.begin() + static_cast<std::ptrdiff_t>(count)},
                                    shares, patches));
    }
    return models;
}

std::vector<std::size_t> nearestPatches(const ModalModel& model, float length, const ModalModel& other,
                                        float otherLength) {
    std::vector<std::size_t> nearest;
    for (const ModalModel::Patch& patch : model.patches) {
        const auto distance = [&](const ModalModel::Patch& o) {
            return glm::distance(patch.place / length, o.place / otherLength);
        };
        nearest.push_back(static_cast<std::size_t>(
            std::min_element(other.patches.begin(), other.patches.end(),
                             [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
            other.patches.begin()));
    }
    return nearest;
}

std::vector<double> stiffnessRatios(const ModalModel& model, const JointTree& other) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < model.modes.size(); ++k) {
        double stiffness = 0.0;
        for (std::size_t i = 0; i < model.joints; ++i) {
            const double angle = model.poses[i * model.columns() + k];
            stiffness += angle * angle * other.links[i / 2].stiffness;
        }
        const double omega = model.modes[k].omega;
        ratios.push_back(stiffness / (omega * omega));
    }
    return ratios;
}

std::vector<double> massRatios(const ModalModel& model, const JointTree& other) {
    const JointMasses masses(other);
    std::vector<double> ratios, angles(model.joints);
    for (std::size_t k = 0; k < model.modes.size(); ++k) {
        for (std::size_t i = 0; i < model.joints; ++i)
            angles[i] = model.poses[i * model.columns() + k];
        const std::vector<double> momenta = masses.times(angles);
        ratios.push_back(std::inner_product(angles.begin(), angles.end(), momenta.begin(), 0.0));
    }
    return ratios;
}

} // namespace osgTreeWind
