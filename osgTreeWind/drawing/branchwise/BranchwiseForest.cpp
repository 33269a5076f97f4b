// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/gpu/branchwise/ForestAnglePasses.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/GLExtensions>
#include <osg/Notify>

#include <atomic>
#include <utility>

namespace osgTreeWind {
namespace {

std::shared_ptr<ForestSimulation> noTrees() {
    ForestDescription none;
    none.law = MotionLaw::Thesis;
    return std::make_shared<ForestSimulation>(none);
}

} // namespace

/// Tests in its first draw whether the context can run the angle passes: render to RGBA32F textures and read
/// textures in vertex shaders, which OpenGL 3.3 (GLSL 3.30) guarantees. Draws nothing.
class BranchwiseForest::FloatTargetProbe : public osg::Drawable {
public:
    enum Answer { UNKNOWN, SUPPORTED, MISSING };

    FloatTargetProbe() {
        setSupportsDisplayList(false);
        setCullingActive(false);
    }
    Answer answer() const { return _answer; }
    osg::BoundingBox computeBoundingBox() const override { return {}; }
    void drawImplementation(osg::RenderInfo& renderInfo) const override {
        if (_answer != UNKNOWN)
            return;
        osg::State& state = *renderInfo.getState();
        const auto* gl = state.get<osg::GLExtensions>();
        const bool supported = gl && gl->isFrameBufferObjectSupported && gl->glslLanguageVersion >= 3.3f;
        _answer = supported ? SUPPORTED : MISSING;
    }

private:
    mutable std::atomic<Answer> _answer{UNKNOWN};
};

BranchwiseForest::BranchwiseForest() : BranchwiseForest(noTrees()) {}

BranchwiseForest::BranchwiseForest(std::shared_ptr<ForestSimulation> simulation) {
    BranchwiseForest::setSimulation(std::move(simulation));
}

BranchwiseForest::BranchwiseForest(const BranchwiseForest& other, const osg::CopyOp& copyop)
    : ForestTechnique(other, copyop), _wantedSource(other._wantedSource), _lodRanges(other._lodRanges) {
    BranchwiseForest::setSimulation(noTrees());
}

BranchwiseForest::~BranchwiseForest() = default;

BranchwiseTrees& branchwiseTrees(const BranchwiseForest& forest) {
    return *forest._trees;
}

const ForestAnglePasses* anglePasses(const BranchwiseForest& forest) {
    return forest._prePass.get();
}

void BranchwiseForest::setSimulation(std::shared_ptr<ForestSimulation> simulation) {
    if (!simulation || !movingForest(*simulation).branches()) {
        OSG_WARN << "osgTreeWind: expected a simulation under a branchwise law; no trees are drawn"
                 << std::endl;
        simulation = noTrees();
    }
    const osg::ref_ptr<BranchwiseTrees> trees = new BranchwiseTrees(simulation);
    _prePass.reset();
    _probe = nullptr;
    ForestTechnique::setSimulation(std::move(simulation));
    _trees = trees;
    addChild(_trees);
    applyLodRanges();
}

void BranchwiseForest::seasonChanged() {
    _trees->showSeason();
    if (_prePass) { // restart the passes with the leaves of the season
        useCpuAngles();
        startPasses();
    }
}

unsigned BranchwiseForest::getNumTrees() const {
    return static_cast<unsigned>(_trees->nodes().size());
}

osg::Node* BranchwiseForest::getTree(unsigned index) const {
    return index < getNumTrees() ? _trees->nodes()[index].get() : nullptr;
}

Diagnostics BranchwiseForest::setLodRanges(const TreeLodRanges& ranges) {
    if (!(ranges.full >= 0.0f))
        return {keyProblem("full", "expected a number at least 0, found " + numberText(ranges.full))};
    if (!(ranges.leaves >= 0.0f))
        return {keyProblem("leaves", "expected a number at least 0, found " + numberText(ranges.leaves))};
    _lodRanges = ranges;
    applyLodRanges();
    return {};
}

void BranchwiseForest::applyLodRanges() {
    for (const osg::ref_ptr<TreeNode>& tree : _trees->nodes())
        tree->getLod()->setRanges(_lodRanges);
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
    _trees->useLeafAngles(nullptr);
}

void BranchwiseForest::startPasses() {
    _prePass = std::make_unique<ForestAnglePasses>(*movingForest(*getSimulation()).branches());
    _trees->useLeafAngles(_prePass->leafAngles());
}

/// Starts the passes after the probe was drawn in a first frame and found the context to support them.
void BranchwiseForest::chooseAngleSource() {
    if (_wantedSource == CPU_ANGLES || _prePass || movingForest(*getSimulation()).placed().units == 0)
        return;
    if (!_probe)
        _probe = new FloatTargetProbe;
    else if (_probe->answer() == FloatTargetProbe::SUPPORTED) {
        _probe = nullptr;
        startPasses();
    } else if (_probe->answer() == FloatTargetProbe::MISSING) {
        OSG_NOTICE << "osgTreeWind: the graphics context lacks float render targets or vertex textures; "
                      "angles come from the CPU"
                   << std::endl;
        setAngleSource(CPU_ANGLES);
    }
}

void BranchwiseForest::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR) {
        if (_probe)
            _probe->accept(visitor);
        if (_prePass)
            _prePass->cull(visitor);
    }
    ForestTechnique::traverse(visitor);
}

void BranchwiseForest::resizeGLObjectBuffers(unsigned maxSize) {
    ForestTechnique::resizeGLObjectBuffers(maxSize);
    if (_prePass)
        _prePass->node()->resizeGLObjectBuffers(maxSize);
}

void BranchwiseForest::releaseGLObjects(osg::State* state) const {
    ForestTechnique::releaseGLObjects(state);
    if (_prePass)
        _prePass->node()->releaseGLObjects(state);
}

void BranchwiseForest::update(const osg::FrameStamp& stamp, bool moved) {
    if (_prePass)
        moved = stepOnGpu(stamp.getSimulationTime(), moved);
    else if (moved)
        _trees->uploadLeafAngles();
    _trees->updatePoses(moved);
    chooseAngleSource(); // for the next frame
}

BranchTransform* BranchwiseForest::branch(TreeId tree, unsigned unit) {
    const ForestSimulation& simulation = *getSimulation();
    return simulation.holds(tree) ? _trees->nodes()[slotOfTree(tree)]->getBranch(unit) : nullptr;
}

bool BranchwiseForest::releaseBranch(TreeId tree, unsigned unit) {
    const ForestSimulation& simulation = *getSimulation();
    return simulation.holds(tree) && _trees->nodes()[slotOfTree(tree)]->releaseBranch(unit);
}

/// @return whether the states of an earlier step were read back.
bool BranchwiseForest::stepOnGpu(double time, bool isDue) {
    const bool moved = _prePass->readBack(*movingForest(*getSimulation()).branches());
    if (isDue)
        _prePass->step(*movingForest(*getSimulation()).branches(), time);
    else
        _prePass->hold();
    return moved;
}

} // namespace osgTreeWind
