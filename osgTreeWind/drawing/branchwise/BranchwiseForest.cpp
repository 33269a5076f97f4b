// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/drawing/branchwise/BillboardDrawable.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/drawing/looks/SpeciesLooks.h>
#include <osgTreeWind/drawing/stand/ModelResources.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/branchwise/AnglePrePass.h>
#include <osgTreeWind/gpu/branchwise/FloatTargetProbe.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/SimulationParts.h>

#include <osg/Notify>

#include <algorithm>
#include <cstring>

namespace osgTreeWind {
namespace {

// Unit 0 is for the textures of bark and leaves, the next ones are where shadow techniques put theirs.
constexpr unsigned unitPosesTextureUnit = 4;
constexpr unsigned leafAnglesTextureUnit = 5;

std::shared_ptr<ForestSimulation> noTrees() {
    ForestDescription none;
    none.law = MotionLaw::Thesis;
    return std::make_shared<ForestSimulation>(none);
}

} // namespace

osg::ref_ptr<osg::Drawable> BranchwiseForest::billboard(const PlacedTree& tree, PosedTree& posed) {
    const Tier tier = impostorTier(tree.leaves);
    Pictures& pictures = _pictures[{tree.model, tier}];
    if (!pictures.strip) {
        const Species& species = _simulation->description().species[tree.species];
        pictures.strip = sharedImpostor(posed.model(), species.appearance, tier);
        pictures.state = new SharedStateSet(*pictures.strip->stateSet());
        pictures.state->addUniform(new osg::Uniform("leanPower", 1.0f)); // it does not lean
    }
    if (tier != Tier::BareImpostor) // twigs have no colour of leaves
        pictures.state->getOrCreateUniform("leafTint", osg::Uniform::FLOAT_VEC3)
            ->set(seasonTint(_simulation->description().species[tree.species].appearance,
                             _simulation->season()));
    osg::ref_ptr<osg::Drawable> drawable =
        new BillboardDrawable(pictures.strip->geometry(), &posed, Random(tree.seed).uniform());
    drawable->setStateSet(pictures.state);
    return drawable;
}

std::string BranchwiseForest::problemOf(const ForestDescription& description) {
    if (description.law == MotionLaw::Modal)
        return {};
    const ShapeFamilies families(description);
    std::vector<std::size_t> units, leaves;
    for (const ShapeFamilies::Family& family : families.all()) {
        const TreeCounts counts = countLargest(family.tree, static_cast<int>(family.shapes));
        units.push_back(counts.units);
        leaves.push_back(counts.leafVertices / verticesPerLeafCluster);
    }
    std::size_t branchTexels = 0, leafTexels = 0;
    for (const TreePlacement& tree : description.trees) {
        branchTexels += 3 * units[families.indexOf(tree)]; // branch parameters are the largest
        leafTexels += leaves[families.indexOf(tree)];
    }
    if (std::max(branchTexels, leafTexels) <= DataTexture::mostTexels)
        return {};
    const bool branches = branchTexels > leafTexels;
    return std::to_string(description.trees.size()) + " trees under a law of a branch need " +
           std::to_string(std::max(branchTexels, leafTexels)) + " texels of " +
           (branches ? "branch parameters" : "leaf angles") + "; a texture holds " +
           std::to_string(DataTexture::mostTexels) + ". The law modal has no such limit";
}

BranchwiseForest::BranchwiseForest() : BranchwiseForest(noTrees()) {}

BranchwiseForest::BranchwiseForest(std::shared_ptr<ForestSimulation> given) : _simulation(std::move(given)) {
    if (!_simulation || !SimulationParts::branches(*_simulation)) {
        OSG_WARN << "osgTreeWind: expected a simulation under a law of a branch; no trees are drawn"
                 << std::endl;
        _simulation = noTrees();
    }
    const ForestSimulation& simulation = *_simulation;

    for (const Species& species : simulation.description().species)
        _styles.push_back(makeTreeStyle(species.appearance));
    for (std::size_t i = 0; i < SimulationParts::models(simulation).size(); ++i) {
        const Species& species =
            simulation.description().species[SimulationParts::forest(simulation).speciesOfModel(i)];
        _buffers.push_back(
            new TreeBuffers(SimulationParts::models(simulation)[i], species.appearance.leafForm));
    }

    _stand = new osg::Group;
    _stand->setName("trees");
    _stand->setDataVariance(osg::Object::DYNAMIC);
    for (std::size_t i = 0; i < SimulationParts::trees(simulation).size(); ++i) {
        const PlacedTree& tree = SimulationParts::trees(simulation)[i];
        osg::ref_ptr<TreeNode> node = new TreeNode(_buffers[tree.model], _styles[tree.species], tree.scale);
        node->setPosition(toOsg(tree.position));
        node->setAttitude(osg::Quat(tree.heading, osg::Z_AXIS));
        node->setTexels(static_cast<int>(tree.firstUnit), static_cast<int>(tree.firstLeaf));
        node->setOwnNumber(Random(tree.seed).uniform());
        node->getPosedTree()->follow(_simulation, simulation.motion(i));
        node->setBranchwise(_branchDrawing == BRANCH_DRAWING);
        node->setLeafwise(_leafDrawing == LEAF_TRANSFORMS);
        _stand->addChild(node);
        _trees.push_back(node);
    }
    addChild(_stand);
    showSeason();

    _unitPoses = std::make_unique<DataTexture>("unit poses", 2 * SimulationParts::forest(simulation).units);
    _leafAngles = std::make_unique<DataTexture>("leaf angles", SimulationParts::forest(simulation).leaves);
    osg::StateSet* state = _stand->getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    bindData(*state, "unitPoses", unitPosesTextureUnit, _unitPoses->texture());
    bindData(*state, "leafAngles", leafAnglesTextureUnit, _leafAngles->texture());
    uploadUnitPoses();
    _leafAngles->fill(SimulationParts::branches(*_simulation)->leaves().states());
}

BranchwiseForest::BranchwiseForest(const BranchwiseForest& other, const osg::CopyOp&)
    : BranchwiseForest(other._simulation) {
    takeSettings(other);
}

BranchwiseForest::~BranchwiseForest() = default;

void BranchwiseForest::showSeason() {
    const std::vector<Species>& species = _simulation->description().species;
    for (std::size_t i = 0; i < species.size(); ++i)
        _styles[i].showSeason(species[i].appearance, _simulation->season());
    for (std::size_t i = 0; i < _trees.size(); ++i) {
        const PlacedTree& tree = SimulationParts::trees(*_simulation)[i];
        _trees[i]->setLeaves(tree.leaves);
        _trees[i]->setBillboard(billboard(tree, *_trees[i]->getPosedTree()));
    }
}

void BranchwiseForest::seasonChanged() {
    showSeason();
    if (_prePass) { // as those of a forest made in that season
        useCpuAngles();
        startPasses();
    }
}

osg::Node* BranchwiseForest::getTree(unsigned index) const {
    return index < _trees.size() ? _trees[index].get() : nullptr;
}

osg::ref_ptr<ForestDrawing> BranchwiseForest::again(std::shared_ptr<ForestSimulation> simulation) const {
    const osg::ref_ptr<BranchwiseForest> drawing = new BranchwiseForest(std::move(simulation));
    drawing->takeSettings(*this);
    return drawing;
}

void BranchwiseForest::takeSettings(const ForestDrawing& former) {
    const auto* other = dynamic_cast<const BranchwiseForest*>(&former);
    if (!other)
        return;
    setAngleSource(other->_wantedSource);
    setBranchDrawing(other->_branchDrawing);
    setLeafDrawing(other->_leafDrawing);
    setLodRanges(other->_lodRanges);
}

void BranchwiseForest::setBranchDrawing(BranchDrawing drawing) {
    _branchDrawing = drawing;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->setBranchwise(drawing == BRANCH_DRAWING);
}

void BranchwiseForest::setLeafDrawing(LeafDrawing drawing) {
    _leafDrawing = drawing;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->setLeafwise(drawing == LEAF_TRANSFORMS);
}

Diagnostics BranchwiseForest::setLodRanges(const TreeLodRanges& ranges) {
    if (!(ranges.full >= 0.0f))
        return {keyProblem("full", "expected a number at least 0, found " + numberText(ranges.full))};
    if (!(ranges.leaves >= 0.0f))
        return {keyProblem("leaves", "expected a number at least 0, found " + numberText(ranges.leaves))};
    _lodRanges = ranges;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->getLod()->setRanges(ranges);
    return {};
}

void BranchwiseForest::setAngleSource(AngleSource source) {
    _wantedSource = source;
    if (source == CPU_ANGLES)
        useCpuAngles();
}

void BranchwiseForest::useCpuAngles() {
    _probe = nullptr;
    if (!_prePass)
        return;
    _prePass.reset();
    bindData(*_stand->getStateSet(), "leafAngles", leafAnglesTextureUnit, _leafAngles->texture());
}

void BranchwiseForest::startPasses() {
    _prePass = std::make_unique<AnglePrePass>(*SimulationParts::branches(*_simulation));
    bindData(*_stand->getStateSet(), "leafAngles", leafAnglesTextureUnit, _prePass->leafAngles());
}

/// The passes start once a first frame has shown that the context can run them.
void BranchwiseForest::chooseAngleSource() {
    if (_wantedSource == CPU_ANGLES || _prePass || SimulationParts::forest(*_simulation).units == 0)
        return;
    if (!_probe)
        _probe = new FloatTargetProbe;
    else if (_probe->answer() == FloatTargetProbe::SUPPORTED) {
        _probe = nullptr;
        startPasses();
    } else if (_probe->answer() == FloatTargetProbe::MISSING) {
        OSG_NOTICE << "osgTreeWind: no float render targets or vertex textures here; angles come from the CPU"
                   << std::endl;
        setAngleSource(CPU_ANGLES);
    }
}

void BranchwiseForest::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR) {
        if (_probe)
            _probe->accept(visitor);
        if (_prePass)
            _prePass->node()->accept(visitor);
    }
    osg::Group::traverse(visitor);
}

void BranchwiseForest::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Group::resizeGLObjectBuffers(maxSize);
    for (const osg::ref_ptr<TreeBuffers>& buffers : _buffers)
        buffers->resizeGLObjectBuffers(maxSize);
    for (const auto& [key, pictures] : _pictures)
        if (pictures.strip)
            pictures.strip->geometry()->resizeGLObjectBuffers(maxSize);
    if (_prePass)
        _prePass->node()->resizeGLObjectBuffers(maxSize);
}

void BranchwiseForest::releaseGLObjects(osg::State* state) const {
    osg::Group::releaseGLObjects(state);
    for (const osg::ref_ptr<TreeBuffers>& buffers : _buffers)
        buffers->releaseGLObjects(state);
    for (const TreeStyle& style : _styles)
        style.releaseGLObjects(state);
    for (const auto& [key, pictures] : _pictures)
        if (pictures.strip) {
            pictures.strip->geometry()->releaseGLObjects(state);
            pictures.state->releaseShared(state);
        }
    if (_prePass)
        _prePass->node()->releaseGLObjects(state);
}

void BranchwiseForest::update(const osg::FrameStamp& stamp) {
    chooseAngleSource();
    const double time = stamp.getSimulationTime();
    const bool moved = _prePass ? stepOnGpu(time) : stepOnCpu(time);
    if (moved)
        uploadUnitPoses();
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->updatePose(moved);
}

BranchTransform* BranchwiseForest::follow(TreeId tree, unsigned unit) {
    return _simulation->holds(tree) ? _trees[_simulation->slotOf(tree)]->getBranch(unit) : nullptr;
}

bool BranchwiseForest::unfollow(TreeId tree, unsigned unit) {
    return _simulation->holds(tree) && _trees[_simulation->slotOf(tree)]->letGo(unit);
}

bool BranchwiseForest::stepOnCpu(double time) {
    if (!_simulation->advance(time))
        return false;
    _leafAngles->fill(SimulationParts::branches(*_simulation)->leaves().states());
    return true;
}

bool BranchwiseForest::stepOnGpu(double time) {
    const bool moved = _prePass->readBack(*SimulationParts::branches(*_simulation));
    if (SimulationParts::beginStep(*_simulation, time))
        _prePass->step(*SimulationParts::branches(*_simulation), time);
    else
        _prePass->hold();
    return moved;
}

void BranchwiseForest::uploadUnitPoses() {
    float* texel = _unitPoses->data();
    for (std::size_t tree = 0; tree < SimulationParts::trees(*_simulation).size(); ++tree)
        for (const UnitPose& pose : _simulation->motion(tree).poses) {
            const float values[8] = {
                pose.rotation.x,    pose.rotation.y,    pose.rotation.z,    pose.rotation.w,
                pose.translation.x, pose.translation.y, pose.translation.z, 0.0f};
            std::memcpy(texel, values, sizeof values);
            texel += 8;
        }
    _unitPoses->dirty();
}

} // namespace osgTreeWind
