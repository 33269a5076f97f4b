// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Forest.h>

#include <osgTreeWind/gpu/AnglePrePass.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/FloatTargetProbe.h>
#include <osgTreeWind/motion/ForestMemory.h>

#include <osg/ApplicationUsage>
#include <osg/NodeVisitor>
#include <osg/Notify>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace osgTreeWind {
namespace {

// Unit 0 is for the textures of bark and leaves, the next ones are where shadow techniques put theirs.
constexpr unsigned unitPosesTextureUnit = 4;
constexpr unsigned leafAnglesTextureUnit = 5;

osg::ApplicationUsageProxy
    anglesUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_ANGLES <cpu|gpu>",
                "Where new osgTreeWind forests work out the angles of branches and leaves.");
osg::ApplicationUsageProxy
    threadsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_THREADS <number>",
                 "Threads that step a large osgTreeWind forest under the law modal; else one for each "
                 "processor. Numbers do not depend on it.");
osg::ApplicationUsageProxy
    instructionsUsage(osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE,
                      "OSGTREEWIND_INSTRUCTIONS <baseline|avx2|avx512>",
                      "The widest instructions that osgTreeWind forests under the law modal may use; else "
                      "what the processor has. Numbers do not depend on it.");
osg::ApplicationUsageProxy memoryUsage(
    osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE, "OSGTREEWIND_MAX_MEMORY <bytes>",
    "Memory that an osgTreeWind forest may need, with k, M, G or T for larger units; else what the "
    "machine has available.");

/// Says once what is going on when it has taken a second.
class Patience {
public:
    explicit Patience(std::size_t trees) : _trees(trees) {}
    void operator()() {
        ++_done;
        if (_said || Clock::now() - _start < std::chrono::seconds(1))
            return;
        _said = true;
        OSG_NOTICE << "osgTreeWind: growing a forest, " << _done << " of " << _trees << " trees so far"
                   << std::endl;
    }

private:
    using Clock = std::chrono::steady_clock;
    std::size_t _trees, _done = 0;
    Clock::time_point _start = Clock::now();
    bool _said = false;
};

Forest::AngleSource environmentSource() {
    const char* value = std::getenv("OSGTREEWIND_ANGLES");
    return value && std::strcmp(value, "gpu") == 0 ? Forest::GPU_ANGLES : Forest::CPU_ANGLES;
}

} // namespace

Forest::Forest() : Forest(ForestDescription()) {}

Forest::Forest(ForestDescription description) : _wantedSource(environmentSource()) {
    setNumChildrenRequiringUpdateTraversal(1);
    setDescription(std::move(description));
}

Forest::Forest(const Forest& other, const osg::CopyOp& copyop)
    : osg::Group(other, copyop), _wantedSource(other._wantedSource), _branchDrawing(other._branchDrawing),
      _leafDrawing(other._leafDrawing) {
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (other.isOwnChild(other.getChild(i)))
            removeChild(i);
    _wind = other.getWind();
    show(other._simulation->restarted());
}

Forest::~Forest() = default;

void Forest::setWind(WindFieldPtr wind) {
    const std::lock_guard<std::mutex> lock(_windMutex);
    _wind.swap(wind); // the old field goes when the parameter does, after the lock
}

WindFieldPtr Forest::getWind() const {
    const std::lock_guard<std::mutex> lock(_windMutex);
    return _wind;
}

void Forest::setDescription(ForestDescription description) {
    if (description.wind)
        setWind(description.wind);
    if (const std::string problem = problemOfMemory(description, true); !problem.empty()) {
        OSG_WARN << "osgTreeWind: " << problem << "; the forest is left empty" << std::endl;
        description = ForestDescription();
    }
    SimulationOptions options;
    options.placed = Patience(description.trees.size());
    show(std::make_shared<ForestSimulation>(std::move(description), options));
}

void Forest::show(std::shared_ptr<ForestSimulation> shown) {
    useCpuAngles();
    removeChild(_stand);
    _trees.clear();
    _simulation = std::move(shown);
    const ForestSimulation& simulation = *_simulation;

    const TreeStyles styles;
    std::vector<TreeStyle> speciesStyles;
    for (const Species& species : simulation.description().species)
        speciesStyles.push_back(styles.style(species.appearance));
    std::vector<osg::ref_ptr<TreeShape>> shapes;
    for (const TreeModel& model : simulation.models())
        shapes.push_back(new TreeShape(std::shared_ptr<const TreeModel>(_simulation, &model)));

    _stand = new osg::Group;
    _stand->setName("trees");
    _stand->setDataVariance(osg::Object::DYNAMIC);
    for (std::size_t i = 0; i < simulation.trees().size(); ++i) {
        const PlacedTree& tree = simulation.trees()[i];
        osg::ref_ptr<TreeNode> node =
            new TreeNode(shapes[tree.model], speciesStyles[tree.species], tree.scale);
        node->setPosition(toOsg(tree.position));
        node->setAttitude(osg::Quat(tree.heading, osg::Z_AXIS));
        node->setTexels(static_cast<int>(tree.firstUnit), static_cast<int>(tree.firstLeaf));
        node->getPosedTree()->follow(_simulation, simulation.motion(i));
        node->setBranchwise(_branchDrawing == BRANCH_DRAWING);
        node->setLeafwise(_leafDrawing == LEAF_TRANSFORMS);
        _stand->addChild(node);
        _trees.push_back(node);
    }
    insertChild(0, _stand);

    _unitPoses = std::make_unique<DataTexture>("unit poses", 2 * simulation.forest().units);
    _leafAngles = std::make_unique<DataTexture>("leaf angles", simulation.forest().leaves);
    osg::StateSet* state = _stand->getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    bindData(*state, "unitPoses", unitPosesTextureUnit, _unitPoses->texture());
    bindData(*state, "leafAngles", leafAnglesTextureUnit, _leafAngles->texture());
    uploadUnitPoses();
    _leafAngles->fill(_simulation->leaves().states());
}

void Forest::setBranchDrawing(BranchDrawing drawing) {
    _branchDrawing = drawing;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->setBranchwise(drawing == BRANCH_DRAWING);
}

void Forest::setLeafDrawing(LeafDrawing drawing) {
    _leafDrawing = drawing;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->setLeafwise(drawing == LEAF_TRANSFORMS);
}

bool Forest::isOwnChild(const osg::Node* child) const {
    return child == _stand || child == _probe || (_prePass && child == _prePass->node());
}

osg::Vec3d Forest::getOrigin() const {
    const glm::dvec3& origin = getDescription().origin;
    return {origin.x, origin.y, origin.z};
}

void Forest::setAngleSource(AngleSource source) {
    _wantedSource = source;
    if (source == CPU_ANGLES)
        useCpuAngles();
}

void Forest::useCpuAngles() {
    removeChild(_probe);
    _probe = nullptr;
    if (!_prePass)
        return;
    removeChild(_prePass->node());
    _prePass.reset();
    bindData(*_stand->getStateSet(), "leafAngles", leafAnglesTextureUnit, _leafAngles->texture());
}

/// The passes start once a first frame has shown that the context can run them.
void Forest::chooseAngleSource() {
    if (_wantedSource == CPU_ANGLES || _prePass || !_simulation->branches() ||
        _simulation->forest().units == 0)
        return;
    if (!_probe) {
        _probe = new FloatTargetProbe;
        addChild(_probe);
    } else if (_probe->answer() == FloatTargetProbe::SUPPORTED) {
        removeChild(_probe);
        _prePass = std::make_unique<AnglePrePass>(*_simulation);
        addChild(_prePass->node());
    } else if (_probe->answer() == FloatTargetProbe::MISSING) {
        OSG_NOTICE << "osgTreeWind: no float render targets or vertex textures here; angles come from the CPU"
                   << std::endl;
        setAngleSource(CPU_ANGLES);
    }
}

void Forest::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR && visitor.getFrameStamp())
        update(*visitor.getFrameStamp());
    osg::Group::traverse(visitor);
}

void Forest::update(const osg::FrameStamp& stamp) {
    if (stamp.getFrameNumber() == _lastFrame)
        return;
    _lastFrame = stamp.getFrameNumber();
    chooseAngleSource();
    _simulation->setWind(getWind());
    const bool moved = _prePass ? stepOnGpu(stamp.getSimulationTime()) : stepOnCpu(stamp.getSimulationTime());
    if (!moved)
        return;
    uploadUnitPoses();
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->updatePose();
}

bool Forest::stepOnCpu(double time) {
    if (!_simulation->advance(time))
        return false;
    _leafAngles->fill(_simulation->leaves().states());
    return true;
}

bool Forest::stepOnGpu(double time) {
    const bool moved = _prePass->readBack(*_simulation, _leafDrawing == LEAF_TRANSFORMS);
    if (const std::optional<float> seconds = _simulation->beginStep(time))
        _prePass->step(*_simulation, time, *seconds);
    else
        _prePass->hold();
    bindData(*_stand->getStateSet(), "leafAngles", leafAnglesTextureUnit, _prePass->leafAngles());
    return moved;
}

void Forest::uploadUnitPoses() {
    float* texel = _unitPoses->data();
    for (std::size_t tree = 0; tree < _simulation->trees().size(); ++tree)
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
