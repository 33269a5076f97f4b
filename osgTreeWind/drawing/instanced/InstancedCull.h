// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/CullLists.h>
#include <osgTreeWind/drawing/instanced/InstancedResources.h>
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>
#include <osgTreeWind/drawing/instanced/PictureView.h>
#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// One cull of a forest's trees by one camera: which trees it sees, at which tiers, and the draws that come
/// of it.
class InstancedCull {
public:
    osgUtil::CullVisitor& visitor;
    unsigned frame;
    const ForestSimulation& simulation;
    const ModalMotion& modal; ///< Of the simulation.
    const InstancedResources& resources;
    const std::vector<osg::ref_ptr<PosePass>>& passes; ///< By model.
    const TreeTiers& tiers;
    float detail; ///< On the trees' heights on the screen.
    const TreeCells& cells;
    const NeighbourShade& shade;
    const std::vector<osg::Vec3>& flutter; ///< By species.
    CullLists& lists;

    void run();

private:
    bool isTreeDown(std::uint32_t number) const;
    ScreenCover::Picture pictureOf(const PictureView& pictures, std::uint32_t number) const;
    void seeCell(const ViewFrustum& view, const PictureView& pictures, const CullLists::SeenCell& seen);
    ScreenCover::Picture seeThroughOthers(const PictureView& pictures, const FrontToBack::Tree& seen);
    void addTree(const FrontToBack::Tree& seen, float clearness);
    void addTree(const FrontToBack::Tree& seen, Tier tier, float fade);
    void handOver();
};

} // namespace osgTreeWind
