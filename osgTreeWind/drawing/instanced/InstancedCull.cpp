// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedCull.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/instanced/PlacedParts.h>
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
    const auto visit = [this](const auto& treeOrPart) { return this->visit(treeOrPart); };
    for (const CullLists::VisibleCell& each : seen) {
        lists.frontToBack().visitNearerThan(each.distance, visit);
        cullCell(each);
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
OcclusionBuffer::Billboard InstancedCull::projectImpostor(std::uint32_t slot) const {
    const PlacedTree& tree = scene.forest.trees()[slot];
    const ModelResources& model = *scene.resources.models[tree.model];
    const SpeciesLooks& looks = scene.resources.looks[tree.species];
    const ImpostorStrip* impostor = model.impostor(impostorTier(tree.leaves));
    if (!impostor || model.usesHostGeometry() || looks.hostBark || looks.hostLeaves || isTreeDown(slot))
        return {};
    return projection.project(tree, modal().lean(slot), *impostor);
}

void InstancedCull::cullCell(const CullLists::VisibleCell& seen) {
    const OcclusionBuffer& occlusion = lists.frontToBack().occlusion();
    osg::Vec2 low, high;
    const bool hidesNoTree = !projection.project(seen.cell->box, low, high) ||
                             occlusion.minTransmittance(low, high) >= OcclusionBuffer::negligible;
    // Seen from far above, impostors hide no others; sorting them would only take time.
    const bool isGrazing = visitor.getViewPointLocal().z() < seen.cell->box.zMax() + 0.15f * seen.distance;
    const std::size_t band = CullLists::bandOf(seen.distance);
    for (const TreeCells::Tree& tree : seen.cell->trees) {
        const bool isDown = isTreeDown(tree.slot);
        const osg::Vec3 top = tree.foot + osg::Vec3(0.0f, 0.0f, isDown ? 0.0f : tree.height);
        if (seen.side == ViewFrustum::Across) {
            const glm::vec2 lean = modal().lean(tree.slot);
            const float sway = 1.5f * (std::abs(lean.x) + std::abs(lean.y)) + 0.05f * tree.height;
            const float reach = isDown ? math::hypot(tree.reach, tree.height) : tree.reach;
            if (!view.intersects(tree.foot, top, reach + sway))
                continue;
        }
        const osg::Vec3 middle = (tree.foot + top) * 0.5f;
        const osg::Vec3 toEye = projection.towardEye(middle);
        const FrontToBackQueue::Tree seenTree{
            tree.slot, band, detail * view.pixels(middle, tree.height), {toEye.x(), toEye.y(), toEye.z()}};
        if (scene.tiers.areEnabled() &&
            (isGrazing || scene.tiers.choose(seenTree.pixels).tier != Tier::Impostor))
            lists.frontToBack().insert(seenTree, projection.distance(tree.foot) - tree.reach);
        else if (hidesNoTree || !occlusion.isHidden(projectImpostor(tree.slot)))
            addTree(seenTree, 1.0f);
    }
}

void InstancedCull::visit(const FrontToBackQueue::Tree& seen) {
    const OcclusionBuffer::Billboard billboard = projectImpostor(seen.slot);
    const OcclusionBuffer& occlusion = lists.frontToBack().occlusion();
    if (occlusion.isHidden(billboard))
        return;
    if (scene.tiers.choose(seen.pixels).tier == Tier::Impostor)
        lists.frontToBack().occludeBy(billboard);
    addTree(seen, occlusion.visibleShare(billboard));
}

bool InstancedCull::visit(const FrontToBackQueue::Part& seen) {
    const bool isHidden = seen.isTestable && lists.frontToBack().occlusion().isHidden(seen.place);
    if (isHidden && !scene.drawsHiddenParts)
        return false;
    const CullLists::DrawnTree& tree = lists.drawnTrees()[seen.tree];
    lists.list({CullLists::bandOf(seen.distance), tree.model}, tree.poses)
        .draw(*seen.mesh, seen.isLeaf, tree.instance);
    return seen.isTestable && !isHidden;
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
    lists.countTree(tier);
    if (tier == Tier::Impostor)
        return addImpostor(seen, fade);
    const PlacedTree& tree = scene.forest.trees()[seen.slot];
    const ModelResources& model = *scene.resources.models[tree.model];
    const NeighbourShade::Light light = scene.shade.light(seen.slot);
    const PosePlaces::Place pose = scene.poses->request(frame, modal(), seen.slot, tree.model, tree.scale,
                                                        scene.resources.looks[tree.species].foliage);
    const float brightness = std::min(model.meshes().leafBrightness[static_cast<int>(tier)], 7.9f);
    const TreeInstance instance{
        {tree.position.x, tree.position.y, tree.position.z, math::tan(0.5f * tree.heading)},
        {tree.scale.axes.x, tree.scale.axes.z, tree.scale.radius, tree.scale.leaf},
        {static_cast<float>(pose.block), fade, treeRandom(tree.seed), tree.leaves},
        {light.atFoot, light.atTop, 1.0f / std::max(scene.cells.tree(seen.slot).height, 1e-3f),
         static_cast<float>(tier) + 0.125f * brightness}};
    const DrawnPoses poses{pose.page, scene.flutter[tree.species]};
    if (model.usesHostGeometry()) {
        lists.list({seen.band, tree.model}, poses).trees.push_back(instance);
    } else {
        lists.drawnTrees().push_back({tree.model, lists.buffer().add(instance), poses});
        queueParts(seen, tier, fade);
    }
}

void InstancedCull::addImpostor(const FrontToBackQueue::Tree& seen, float fade) {
    const PlacedTree& tree = scene.forest.trees()[seen.slot];
    const glm::vec2 lean = modal().lean(seen.slot);
    const TreeFall* fall = modal().fall(seen.slot);
    const glm::vec3 down =
        fall ? rotateAboutZ({fall->trunkTurn(), 0.0f}, math::sin(tree.heading), math::cos(tree.heading))
             : glm::vec3(0.0f);
    const NeighbourShade::Light light = scene.shade.light(seen.slot);
    const bool small = seen.pixels < ImpostorStrip::bendingPixels;
    lists.list({seen.band, tree.model, impostorTier(tree.leaves), small})
        .trees.push_back({{tree.position.x, tree.position.y, tree.position.z, tree.heading},
                          {tree.scale.axes.x, tree.scale.axes.z, down.x, down.y},
                          {lean.x, lean.y, fade, treeRandom(tree.seed)},
                          {light.atFoot, light.atTop, 0.0f, 0.0f}});
}

/// Queues the parts that may be in view. Parts of fallen and breaking trees are anywhere: they are all drawn.
void InstancedCull::queueParts(const FrontToBackQueue::Tree& seen, Tier tier, float fade) {
    const PlacedTree& tree = scene.forest.trees()[seen.slot];
    const ModelMeshes& meshes = scene.resources.models[tree.model]->meshes();
    const bool isWhole = !modal().fall(seen.slot);
    PlacedParts placed(view, projection, tree, modal().lean(seen.slot), scene.cells.tree(seen.slot).height);
    const auto drawn = static_cast<std::uint32_t>(lists.drawnTrees().size() - 1);
    const float share = fade == 1.0f ? 1.0f : fade > 1.0f ? fade - 1.0f : std::abs(fade);
    for (const bool isLeaf : {true, false}) {
        const TierMeshes& mesh = isLeaf ? meshes.leaves : meshes.bark;
        const float cover = share * (isLeaf ? tree.leaves * tree.scale.leaf * tree.scale.leaf
                                            : tree.scale.radius * tree.scale.axes.z);
        placed.setReachScale(isLeaf ? tree.scale.leaf : tree.scale.radius);
        for (const MeshPart& part : mesh.parts[static_cast<int>(tier)]) {
            if (isWhole && !placed.isInView(part))
                continue;
            FrontToBackQueue::Part queued{&part, drawn, placed.distance(part), isLeaf, false, {}};
            queued.isTestable = isWhole && placed.project(part, cover, queued.place);
            lists.frontToBack().insert(queued);
        }
    }
}

namespace {

/// Adds draws to the render bin of a camera.
class DrawSubmission {
public:
    using States = std::initializer_list<osg::StateSet*>; ///< The outermost comes first. Null is ignored.

    DrawSubmission(osgUtil::CullVisitor& visitor, DrawBuffer& buffer)
        : _visitor(visitor), _buffer(buffer), _depth(visitor.getDistanceFromEyePoint(osg::Vec3(), true)) {}

    /// Adds a draw of the trees of a list, with geometry of a host, which may be null.
    void drawWhole(InstancedDraw& part, osg::Geometry* geometry, const CullLists::List& list, States states) {
        if (!geometry || list.trees.empty())
            return;
        const osg::Array* vertices = geometry->getVertexArray(); // null in some geometry of hosts
        part.drawInstances(list.firstInstance, static_cast<std::uint32_t>(list.trees.size()));
        add(part, geometry, list, list.trees.size() * (vertices ? vertices->getNumElements() : 0), states);
    }
    void drawCommands(InstancedDraw& part, osg::Geometry* geometry, const CullLists::List& list,
                      const std::vector<DrawCommand>& commands, States states) {
        if (commands.empty())
            return;
        std::size_t indices = 0;
        for (const DrawCommand& each : commands)
            indices += std::size_t(each.instances) * each.indices;
        part.drawCommands(_buffer.add(commands.data(), commands.size()),
                          static_cast<std::uint32_t>(commands.size()));
        add(part, geometry, list, indices / 2, states);
    }
    bool isEmpty() const { return _isEmpty; }

private:
    void add(InstancedDraw& part, osg::Geometry* geometry, const CullLists::List& list, std::size_t vertices,
             States states) {
        constexpr std::size_t verticesPerFlush = 300000;
        _isEmpty = false;
        _unflushed += vertices;
        const bool flush = _unflushed > verticesPerFlush;
        part.set(geometry, &_buffer, list.poses, flush);
        if (flush)
            _unflushed = 0;
        int pushed = 0;
        for (osg::StateSet* state : states)
            if (state) {
                _visitor.pushStateSet(state);
                ++pushed;
            }
        _visitor.addDrawableAndDepth(&part, _visitor.getModelViewMatrix(), _depth);
        for (; pushed > 0; --pushed)
            _visitor.popStateSet();
    }

    osgUtil::CullVisitor& _visitor;
    DrawBuffer& _buffer;
    const float _depth;
    std::size_t _unflushed = 0; ///< Vertices, about.
    bool _isEmpty = true;
};

} // namespace

/// Adds the draws to the camera's render bin, and the lists as a stage that computes poses first. Leaves come
/// before the bark of their band: they hide much of it, and its pixels cost more.
void InstancedCull::submitDraws() {
    if (lists.size() == 0)
        return;
    const std::initializer_list<osg::StateSet*> common = {scene.resources.state, lists.shading(),
                                                          scene.poses->state()};
    for (osg::StateSet* state : common)
        visitor.pushStateSet(state);
    DrawBuffer& buffer = lists.buffer();
    for (std::size_t i = 0; i < lists.size(); ++i) {
        lists[i].firstInstance = static_cast<std::uint32_t>(buffer.instanceCount());
        for (const TreeInstance& tree : lists[i].trees)
            buffer.add(tree);
    }
    buffer.poses = scene.poses;
    const auto& looks = scene.resources.looks;
    buffer.hasHostState = std::any_of(looks.begin(), looks.end(), [](const SpeciesLooks& each) {
        return each.hostBark || each.hostLeaves;
    });
    DrawSubmission draws(visitor, buffer);
    const auto arraysOf = [&](const ModelResources& model) {
        return model.usesHostGeometry() ? scene.resources.hostArrays.get() : nullptr;
    };
    for (std::size_t band = 0; band < CullLists::bands; ++band) {
        osg::StateSet* const inBand = lists.bandState(band);
        const auto forEachList = [&](bool impostors, const auto& draw) {
            for (std::size_t i = 0; i < lists.size(); ++i) {
                CullLists::List& list = lists[i];
                const ModelResources& model = *scene.resources.models[list.model];
                if (list.band == band && (list.tier >= Tier::Impostor) == impostors)
                    draw(list, model, looks[model.species()]);
            }
        };
        forEachList(false, [&](auto& list, const auto& model, const auto& looks) {
            const auto states = {inBand, model.state(), looks.leaves.get(), arraysOf(model),
                                 looks.hostLeaves.get()};
            draws.drawWhole(*list.leaves, model.hostLeaves(), list, states);
            draws.drawCommands(*list.leaves, model.meshes().leaves.geometry, list, list.leafCommands, states);
        });
        forEachList(false, [&](auto& list, const auto& model, const auto& looks) {
            const auto states = {inBand, model.state(), looks.bark.get(), arraysOf(model),
                                 looks.hostBark.get()};
            draws.drawWhole(*list.bark, model.hostBark(), list, states);
            draws.drawCommands(*list.bark, model.meshes().bark.geometry, list, list.barkCommands, states);
        });
        forEachList(true, [&](auto& list, const auto& model, const auto& looks) {
            const ImpostorStrip& impostor = *model.impostor(list.tier);
            osg::Geometry* const strip = list.small ? impostor.straightGeometry() : impostor.geometry();
            osg::StateSet* const leaves = // sets the leaf colour, which twigs lack
                list.tier == Tier::BareImpostor ? nullptr : looks.impostors.get();
            list.barkCommands.push_back({strip->getPrimitiveSet(0)->getNumIndices(),
                                         static_cast<std::uint32_t>(list.trees.size()), 0, 0,
                                         list.firstInstance});
            draws.drawCommands(*list.bark, strip, list, list.barkCommands,
                               {inBand, impostor.stateSet(), leaves});
        });
    }
    buffer.instances->dirty();
    buffer.commands->dirty();
    for (std::size_t i = 0; i < common.size(); ++i)
        visitor.popStateSet();
    if (!draws.isEmpty()) // without draws, OSG deletes the state graph that the stage refers to
        visitor.getCurrentRenderBin()->getStage()->addPreRenderStage(&lists);
}

} // namespace osgTreeWind
