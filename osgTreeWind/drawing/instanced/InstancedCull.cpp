// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedCull.h>

#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace osgTreeWind {

namespace {

/// 0 within it.
float distanceFrom(const osg::Vec3& point, const osg::BoundingBox& box) {
    osg::Vec3 away;
    for (int i = 0; i < 3; ++i)
        away[i] = std::max({box._min[i] - point[i], 0.0f, point[i] - box._max[i]});
    return away.length();
}

} // namespace

void InstancedCull::run() {
    lists.begin(frame, resources.models.size(), visitor.getCurrentStateGraph(), visitor.getCurrentCamera());
    const ViewFrustum view(visitor);
    const PictureView pictures(visitor);
    const bool nearFar = visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR;
    const osg::Vec3 eye = visitor.getViewPointLocal();
    auto& seen = lists.seenCells();
    seen.clear();
    lists.frontToBack().clear();
    for (const TreeCells::Cell& cell : cells.cells())
        if (!cell.trees.empty())
            if (const ViewFrustum::Side side = view.sideOf(cell.box); side != ViewFrustum::Outside)
                seen.push_back({distanceFrom(eye, cell.box), &cell, side});
    std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
        return std::tie(a.distance, a.cell) < std::tie(b.distance, b.cell);
    });
    const auto see = [&](const FrontToBack::Tree& tree) { return seeThroughOthers(pictures, tree); };
    for (const CullLists::SeenCell& each : seen) {
        lists.frontToBack().takeBefore(each.distance, see);
        seeCell(view, pictures, each);
        if (!nearFar)
            continue;
        if (each.distance > 0.0f) {
            visitor.updateCalculatedNearFar(*visitor.getModelViewMatrix(), each.cell->box);
            continue;
        }
        for (const TreeCells::Tree& tree : each.cell->trees) // not as near as the cell, which is all about it
            visitor.updateCalculatedNearFar(*visitor.getModelViewMatrix(), TreeCells::boxOf(tree));
    }
    lists.frontToBack().takeAll(see);
    handOver();
}

bool InstancedCull::isTreeDown(std::uint32_t number) const {
    const TreeFall* fall = modal.fall(number);
    return fall && fall->isDown;
}

/// None of a tree that lies, nor of one that a host draws in its own way.
ScreenCover::Picture InstancedCull::pictureOf(const PictureView& pictures, std::uint32_t number) const {
    const PlacedTree& tree = SimulationParts::trees(simulation)[number];
    const ModelResources& model = *resources.models[tree.model];
    const SpeciesLooks& looks = resources.looks[tree.species];
    const ImpostorStrip* impostor = model.impostor(impostorTier(tree.leaves));
    if (!impostor || model.isOfHost() || looks.ownBark || looks.ownLeaves || isTreeDown(number))
        return {};
    return pictures.place(tree, modal.lean(number), *impostor);
}

void InstancedCull::seeCell(const ViewFrustum& view, const PictureView& pictures,
                            const CullLists::SeenCell& seen) {
    const ScreenCover& cover = lists.frontToBack().cover();
    osg::Vec2 low, high;
    const bool isClear = !pictures.place(seen.cell->box, low, high) ||
                         cover.leastShown(low, high) >= ScreenCover::hardly; // hides no tree of the cell
    const std::size_t band = CullLists::bandOf(seen.distance);
    for (const TreeCells::Tree& tree : seen.cell->trees) {
        const bool isDown = isTreeDown(tree.number);
        const osg::Vec3 top = tree.foot + osg::Vec3(0.0f, 0.0f, isDown ? 0.0f : tree.height);
        if (seen.side == ViewFrustum::Across) {
            const glm::vec2 lean = modal.lean(tree.number);
            const float sway = 1.5f * (std::abs(lean.x) + std::abs(lean.y)) + 0.05f * tree.height;
            const float reach = isDown ? std::hypot(tree.reach, tree.height) : tree.reach;
            if (!view.sees(tree.foot, top, reach + sway))
                continue;
        }
        const osg::Vec3 middle = (tree.foot + top) * 0.5f;
        const osg::Vec3 toEye = pictures.towardEye(middle);
        const FrontToBack::Tree seenTree{
            tree.number, band, detail * view.pixels(middle, tree.height), {toEye.x(), toEye.y(), toEye.z()}};
        if (tiers.on() && tiers.choose(seenTree.pixels).tier != Tier::Impostor)
            lists.frontToBack().put(seenTree, pictures.distance(tree.foot));
        else if (isClear || !cover.hides(pictureOf(pictures, tree.number), pictures.pixel()))
            addTree(seenTree, 1.0f);
    }
}

ScreenCover::Picture InstancedCull::seeThroughOthers(const PictureView& pictures,
                                                     const FrontToBack::Tree& seen) {
    const ScreenCover::Picture picture = pictureOf(pictures, seen.number);
    const ScreenCover& cover = lists.frontToBack().cover();
    if (!cover.hides(picture, pictures.pixel()))
        addTree(seen, cover.clearness(picture));
    return picture;
}

/// What is seen through gaps of others needs less detail.
void InstancedCull::addTree(const FrontToBack::Tree& seen, float clearness) {
    const float pixels = seen.pixels * clearness;
    const TierChoice choice = tiers.choose(pixels);
    if (choice.fade == 1.0f) {
        addTree(seen, choice.tier, 1.0f);
    } else {
        const Tier next = static_cast<Tier>(static_cast<int>(choice.tier) + 1);
        const float fade = next == Tier::Impostor ? choice.fade : 1.0f + choice.fade;
        addTree(seen, choice.tier, fade);
        addTree(seen, next, -fade);
    }
    if (choice.tier < Tier::Impostor || pixels > tiers.wakingPixels())
        lists.near().push_back(seen.number);
}

void InstancedCull::addTree(const FrontToBack::Tree& seen, Tier tier, float fade) {
    const PlacedTree& tree = SimulationParts::trees(simulation)[seen.number];
    const float own = ownNumber(tree.seed);
    const glm::vec3& foot = tree.position;
    const NeighbourShade::Left left = shade.left(seen.number);
    if (tier == Tier::Impostor) {
        const glm::vec2 lean = modal.lean(seen.number);
        const TreeFall* fall = modal.fall(seen.number);
        const glm::vec3 down =
            fall ? turnHeading({fall->trunkTurn(), 0.0f}, std::sin(tree.heading), std::cos(tree.heading))
                 : glm::vec3(0.0f);
        const bool small = seen.pixels < ImpostorStrip::bendingPixels;
        lists.list({seen.band, tree.model, impostorTier(tree.leaves), fade != 1.0f, small, 0})
            .add({{foot.x, foot.y, foot.z, tree.heading},
                  {tree.scale.axes.x, tree.scale.axes.z, down.x, down.y},
                  {lean.x, lean.y, fade, own},
                  {left.atFoot, left.atTop, 0.0f, 0.0f}});
        return;
    }
    PosePass& pass = *passes[tree.model];
    const PosePass::Row row = pass.row(frame, seen.number, [&](PoseRequest& request) {
        pass.ask(modal, seen.number, tree.scale, resources.looks[tree.species].foliage, request);
    });
    const std::size_t order =
        LeafOrders::nearest(turnHeading(seen.toEye, -std::sin(tree.heading), std::cos(tree.heading)));
    InstanceList& list =
        lists.list({seen.band, tree.model, tier, fade != 1.0f, false, order}, &pass, row.page);
    list.flutter = flutter[tree.species];
    list.add({{foot.x, foot.y, foot.z, std::tan(0.5f * tree.heading)},
              {tree.scale.axes.x, tree.scale.axes.z, tree.scale.radius, tree.scale.leaf},
              {static_cast<float>(row.row), fade, own, tree.leaves},
              {left.atFoot, left.atTop, 1.0f / std::max(cells.tree(seen.number).height, 1e-3f), 0.0f}});
}

/// Draws and passes, to the camera's render stage.
void InstancedCull::handOver() {
    if (lists.size() == 0)
        return;
    visitor.pushStateSet(resources.state);
    visitor.pushStateSet(lists.shading());
    const float depth = visitor.getDistanceFromEyePoint(osg::Vec3(), true);
    constexpr std::size_t atOnce = 300000; // vertices after which the driver is to begin
    std::size_t waiting = 0;
    bool drawn = false;
    const auto draw = [&](osg::Geometry* geometry, InstancedDraw& part, InstanceList& trees,
                          std::initializer_list<osg::StateSet*> states) {
        if (!geometry)
            return;
        drawn = true;
        if (const osg::Array* vertices = geometry->getVertexArray()) // a host's may have others
            waiting += trees.size() * vertices->getNumElements();
        const bool isLast = waiting > atOnce;
        part.set(geometry, &trees, isLast);
        if (isLast)
            waiting = 0;
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
        osg::StateSet* const fading = list.fading ? resources.fading.get() : nullptr;
        const ModelResources& model = *resources.models[list.model];
        const SpeciesLooks& looks = resources.looks[model.species()];
        if (list.tier >= Tier::Impostor) {
            const ImpostorStrip& impostor = *model.impostor(list.tier);
            osg::StateSet* const leaves = // their colour, which twigs have not
                list.tier == Tier::BareImpostor ? nullptr : looks.impostors.get();
            draw(list.small ? impostor.straight() : impostor.geometry(), *list.bark, *list.trees,
                 {inBand, fading, impostor.stateSet(), leaves});
            continue;
        }
        draw(model.leaves(list.tier, list.order), *list.leaves, *list.trees,
             {inBand, fading, looks.leaves, model.state(list.tier), looks.ownLeaves});
        draw(model.bark(list.tier), *list.bark, *list.trees,
             {inBand, fading, looks.bark, model.state(list.tier), looks.ownBark});
    }
    visitor.popStateSet();
    visitor.popStateSet();
    if (drawn) // else their place in the scene's state is gone before that
        visitor.getCurrentRenderBin()->getStage()->addPreRenderStage(&lists);
}

} // namespace osgTreeWind
