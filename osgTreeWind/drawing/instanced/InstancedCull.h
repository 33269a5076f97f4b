// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/CullLists.h>
#include <osgTreeWind/drawing/instanced/ImpostorProjection.h>
#include <osgTreeWind/drawing/instanced/InstancedResources.h>
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>
#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Culls a forest for one camera: finds the visible trees, chooses their tiers and submits their draws.
class InstancedCull {
public:
    osgUtil::CullVisitor& visitor;
    unsigned frame;
    const ForestSimulation& simulation;
    const ModalMotion& modal; ///< Of the simulation.
    const InstancedResources& resources;
    const std::vector<osg::ref_ptr<PosePass>>& passes; ///< By model.
    const TreeTiers& tiers;
    float detail; ///< Factor on the screen heights of the trees (DetailBudget).
    const TreeCells& cells;
    const NeighbourShade& shade;
    const std::vector<osg::Vec3>& flutter; ///< By species.
    CullLists& lists;

    void run();

private:
    bool isTreeDown(std::uint32_t slot) const;
    OcclusionBuffer::Billboard projectImpostor(const ImpostorProjection& projection,
                                               std::uint32_t slot) const;
    void cullCell(const ViewFrustum& view, const ImpostorProjection& projection,
                  const CullLists::VisibleCell& seen);
    OcclusionBuffer::Billboard drawUnlessHidden(const ImpostorProjection& projection,
                                                const FrontToBackQueue::Tree& seen);
    void addTree(const FrontToBackQueue::Tree& seen, float visibleShare);
    void addInstance(const FrontToBackQueue::Tree& seen, Tier tier, float fade);
    void submitDraws();
};

} // namespace osgTreeWind
