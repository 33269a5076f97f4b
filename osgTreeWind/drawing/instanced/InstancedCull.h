// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/CullLists.h>
#include <osgTreeWind/drawing/instanced/ImpostorProjection.h>
#include <osgTreeWind/drawing/instanced/InstancedResources.h>
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>
#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// What all cameras see: the trees of a forest under the law `modal`, and how they are drawn.
struct InstancedScene {
    MovingForest& forest;
    InstancedResources resources;
    TreeTiers tiers;
    osg::ref_ptr<PosePass> poses = new PosePass(resources.programs);
    mutable TreeCells cells{}; // they cache their bounds
    NeighbourShade shade{};
    std::vector<osg::Vec3> flutter{}; ///< By species: current phases.
    bool drawsHiddenParts = false;    ///< For comparison: draws parts that others hide.
};

/// Culls a forest for one camera: finds the visible trees, chooses their tiers and submits their draws.
class InstancedCull {
public:
    osgUtil::CullVisitor& visitor;
    unsigned frame;
    const InstancedScene& scene;
    float detail; ///< Factor on the screen heights of the trees (DetailBudget).
    CullLists& lists;
    ViewFrustum view{visitor};
    ImpostorProjection projection{visitor};

    void run();

private:
    const ModalMotion& modal() const { return *scene.forest.modal(); }
    bool isTreeDown(std::uint32_t slot) const;
    OcclusionBuffer::Billboard projectImpostor(std::uint32_t slot) const;
    void cullCell(const CullLists::VisibleCell& seen);
    void visit(const FrontToBackQueue::Tree& seen);
    bool visit(const FrontToBackQueue::Part& seen);
    void addTree(const FrontToBackQueue::Tree& seen, float visibleShare);
    void addInstance(const FrontToBackQueue::Tree& seen, Tier tier, float fade);
    void addImpostor(const FrontToBackQueue::Tree& seen, float fade);
    void queueParts(const FrontToBackQueue::Tree& seen, Tier tier, float fade);
    void submitDraws();
};

} // namespace osgTreeWind
