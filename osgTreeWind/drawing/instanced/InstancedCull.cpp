// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedCull.h>

#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace osgTreeWind {
namespace {

/// 0 inside the box.
float distanceFrom(const osg::Vec3& point, const osg::BoundingBox& box) {
    osg::Vec3 away;
    for (int i = 0; i < 3; ++i)
        away[i] = std::max({box._min[i] - point[i], 0.0f, point[i] - box._max[i]});
    return away.length();
}

} // namespace

void InstancedCull::run() {
    lists.begin(frame, scene.resources.models.size(), visitor.getCurrentRenderBin()->getStage(),
                visitor.getCurrentStateGraph(), visitor.getCurrentCamera());
    lists.shading()
        ->getOrCreateUniform("viewportHeight", osg::Uniform::FLOAT)
        ->set(static_cast<float>(visitor.getViewport()->height()));
    const ViewFrustum view(visitor);
    const ImpostorProjection projection(visitor);
    const bool nearFar = visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR;
    const osg::Vec3 eye = visitor.getViewPointLocal();
    auto& seen = lists.visibleCells();
    seen.clear();
    lists.frontToBack().clear();
    for (const TreeCells::Cell& cell : scene.cells.cells())
        if (!cell.trees.empty())
            if (const ViewFrustum::Side side = view.classify(cell.box); side != ViewFrustum::Outside)
                seen.push_back({distanceFrom(eye, cell.box), &cell, side});
    std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
        return std::tie(a.distance, a.cell) < std::tie(b.distance, b.cell);
    });
    const auto visit = [&](const FrontToBackQueue::Tree& tree) { return drawUnlessHidden(projection, tree); };
    for (const CullLists::VisibleCell& each : seen) {
        lists.frontToBack().visitNearerThan(each.distance, visit);
        cullCell(view, projection, each);
        if (!nearFar)
            continue;
        if (each.distance > 0.0f) {
            visitor.updateCalculatedNearFar(*visitor.getModelViewMatrix(), each.cell->box);
            continue;
        }
        for (const TreeCells::Tree& tree : each.cell->trees) // the eye is inside the box of the cell
            visitor.updateCalculatedNearFar(*visitor.getModelViewMatrix(), TreeCells::swayBox(tree));
    }
    lists.frontToBack().visitAll(visit);
    submitDraws();
}

bool InstancedCull::isTreeDown(std::uint32_t slot) const {
    const TreeFall* fall = modal().fall(slot);
    return fall && fall->isDown;
}

/// Without coverage for fallen trees and for trees with geometry or state from the host.
OcclusionBuffer::Billboard InstancedCull::projectImpostor(const ImpostorProjection& projection,
                                                          std::uint32_t slot) const {
    const PlacedTree& tree = scene.forest.trees()[slot];
    const ModelResources& model = *scene.resources.models[tree.model];
    const SpeciesLooks& looks = scene.resources.looks[tree.species];
    const ImpostorStrip* impostor = model.impostor(impostorTier(tree.leaves));
    if (!impostor || model.usesHostGeometry() || looks.hostBark || looks.hostLeaves || isTreeDown(slot))
        return {};
    return projection.project(tree, modal().lean(slot), *impostor);
}

void InstancedCull::cullCell(const ViewFrustum& view, const ImpostorProjection& projection,
                             const CullLists::VisibleCell& seen) {
    const OcclusionBuffer& occlusion = lists.frontToBack().occlusion();
    osg::Vec2 low, high;
    const bool hidesNoTree = !projection.project(seen.cell->box, low, high) ||
                             occlusion.minTransmittance(low, high) >= OcclusionBuffer::negligible;
    const std::size_t band = CullLists::bandOf(seen.distance);
    for (const TreeCells::Tree& tree : seen.cell->trees) {
        const bool isDown = isTreeDown(tree.slot);
        const osg::Vec3 top = tree.foot + osg::Vec3(0.0f, 0.0f, isDown ? 0.0f : tree.height);
        if (seen.side == ViewFrustum::Across) {
            const glm::vec2 lean = modal().lean(tree.slot);
            const float sway = 1.5f * (std::abs(lean.x) + std::abs(lean.y)) + 0.05f * tree.height;
            const float reach = isDown ? std::hypot(tree.reach, tree.height) : tree.reach;
            if (!view.intersects(tree.foot, top, reach + sway))
                continue;
        }
        const osg::Vec3 middle = (tree.foot + top) * 0.5f;
        const osg::Vec3 toEye = projection.towardEye(middle);
        const FrontToBackQueue::Tree seenTree{
            tree.slot, band, detail * view.pixels(middle, tree.height), {toEye.x(), toEye.y(), toEye.z()}};
        if (scene.tiers.areEnabled() && scene.tiers.choose(seenTree.pixels).tier != Tier::Impostor)
            lists.frontToBack().insert(seenTree, projection.distance(tree.foot));
        else if (hidesNoTree ||
                 !occlusion.isHidden(projectImpostor(projection, tree.slot), projection.pixelShare()))
            addTree(seenTree, 1.0f);
    }
}

OcclusionBuffer::Billboard InstancedCull::drawUnlessHidden(const ImpostorProjection& projection,
                                                           const FrontToBackQueue::Tree& seen) {
    const OcclusionBuffer::Billboard billboard = projectImpostor(projection, seen.slot);
    const OcclusionBuffer& occlusion = lists.frontToBack().occlusion();
    if (!occlusion.isHidden(billboard, projection.pixelShare()))
        addTree(seen, occlusion.visibleShare(billboard));
    return billboard;
}

/// Trees that are seen through gaps in other trees need less detail.
void InstancedCull::addTree(const FrontToBackQueue::Tree& seen, float visibleShare) {
    const float pixels = seen.pixels * visibleShare;
    const TierChoice choice = scene.tiers.choose(pixels);
    if (choice.fade == 1.0f) {
        addInstance(seen, choice.tier, 1.0f);
    } else {
        const Tier next = static_cast<Tier>(static_cast<int>(choice.tier) + 1);
        const float fade = next == Tier::Impostor ? choice.fade : 1.0f + choice.fade;
        addInstance(seen, choice.tier, fade);
        addInstance(seen, next, -fade);
    }
    if (choice.tier < Tier::Impostor || pixels > scene.tiers.fullMotionPixels())
        lists.nearTrees().push_back(seen.slot);
}

void InstancedCull::addInstance(const FrontToBackQueue::Tree& seen, Tier tier, float fade) {
    const PlacedTree& tree = scene.forest.trees()[seen.slot];
    const float random = treeRandom(tree.seed);
    const glm::vec3& foot = tree.position;
    const NeighbourShade::Light light = scene.shade.light(seen.slot);
    if (tier == Tier::Impostor) {
        const glm::vec2 lean = modal().lean(seen.slot);
        const TreeFall* fall = modal().fall(seen.slot);
        const glm::vec3 down =
            fall ? rotateAboutZ({fall->trunkTurn(), 0.0f}, std::sin(tree.heading), std::cos(tree.heading))
                 : glm::vec3(0.0f);
        const bool small = seen.pixels < ImpostorStrip::bendingPixels;
        lists.list({seen.band, tree.model, impostorTier(tree.leaves), fade != 1.0f, small, 0})
            .add({{foot.x, foot.y, foot.z, tree.heading},
                  {tree.scale.axes.x, tree.scale.axes.z, down.x, down.y},
                  {lean.x, lean.y, fade, random},
                  {light.atFoot, light.atTop, 0.0f, 0.0f}});
        return;
    }
    PosePass& pass = *scene.passes[tree.model];
    const PosePass::Row row = pass.row(frame, seen.slot, [&](PoseRequest& request) {
        pass.fillRequest(modal(), seen.slot, tree.scale, scene.resources.looks[tree.species].foliage,
                         request);
    });
    const std::size_t order =
        LeafOrders::nearest(rotateAboutZ(seen.toEye, -std::sin(tree.heading), std::cos(tree.heading)));
    InstanceList& list =
        lists.list({seen.band, tree.model, tier, fade != 1.0f, false, order}, &pass, row.page);
    list.flutter = scene.flutter[tree.species];
    list.add({{foot.x, foot.y, foot.z, std::tan(0.5f * tree.heading)},
              {tree.scale.axes.x, tree.scale.axes.z, tree.scale.radius, tree.scale.leaf},
              {static_cast<float>(row.row), fade, random, tree.leaves},
              {light.atFoot, light.atTop, 1.0f / std::max(scene.cells.tree(seen.slot).height, 1e-3f), 0.0f}});
}

/// Adds the draws to the camera's render bin, and the lists as a stage that computes poses first.
void InstancedCull::submitDraws() {
    if (lists.size() == 0)
        return;
    visitor.pushStateSet(scene.resources.state);
    visitor.pushStateSet(lists.shading());
    const float depth = visitor.getDistanceFromEyePoint(osg::Vec3(), true);
    constexpr std::size_t verticesPerFlush = 300000;
    std::size_t vertexCount = 0; // since the last flush
    bool drawn = false;
    const auto draw = [&](osg::Geometry* geometry, InstancedDraw& part, InstanceList& trees,
                          std::initializer_list<osg::StateSet*> states) {
        if (!geometry)
            return;
        drawn = true;
        if (const osg::Array* vertices = geometry->getVertexArray()) // null in some geometry of hosts
            vertexCount += trees.size() * vertices->getNumElements();
        const bool flush = vertexCount > verticesPerFlush;
        part.set(geometry, &trees, flush);
        if (flush)
            vertexCount = 0;
        int pushed = 0;
        for (osg::StateSet* state : states)
            if (state) {
                visitor.pushStateSet(state);
                ++pushed;
            }
        visitor.addDrawableAndDepth(&part, visitor.getModelViewMatrix(), depth);
        for (; pushed > 0; --pushed)
            visitor.popStateSet();
    };
    for (std::size_t i = 0; i < lists.size(); ++i) {
        CullLists::List& list = lists[i];
        list.trees->values->dirty();
        osg::StateSet* const inBand = lists.bandState(list.band);
        osg::StateSet* const fading = list.fading ? scene.resources.fading.get() : nullptr;
        const ModelResources& model = *scene.resources.models[list.model];
        const SpeciesLooks& looks = scene.resources.looks[model.species()];
        if (list.tier >= Tier::Impostor) {
            const ImpostorStrip& impostor = *model.impostor(list.tier);
            osg::StateSet* const leaves = // sets the leaf colour, which twigs lack
                list.tier == Tier::BareImpostor ? nullptr : looks.impostors.get();
            draw(list.small ? impostor.straightGeometry() : impostor.geometry(), *list.bark, *list.trees,
                 {inBand, fading, impostor.stateSet(), leaves});
            continue;
        }
        draw(model.leaves(list.tier, list.order), *list.leaves, *list.trees,
             {inBand, fading, looks.leaves, model.state(list.tier), looks.hostLeaves});
        draw(model.bark(list.tier), *list.bark, *list.trees,
             {inBand, fading, looks.bark, model.state(list.tier), looks.hostBark});
    }
    visitor.popStateSet();
    visitor.popStateSet();
    if (drawn) // without draws, OSG deletes the state graph that the stage refers to
        visitor.getCurrentRenderBin()->getStage()->addPreRenderStage(&lists);
}

} // namespace osgTreeWind
