// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Forest.h>

#include <osgTreeWind/motion/ForestMemory.h>

#include <osg/ApplicationUsage>
#include <osg/NodeVisitor>
#include <osg/Notify>

#include <chrono>

namespace osgTreeWind {
namespace {

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

} // namespace

Forest::Forest() : Forest(ForestDescription()) {}

Forest::Forest(ForestDescription description) {
    setNumChildrenRequiringUpdateTraversal(1);
    setDescription(std::move(description));
}

Forest::Forest(const Forest& other, const osg::CopyOp& copyop) : osg::Group(other, copyop) {
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (other.isOwnChild(other.getChild(i)))
            removeChild(i);
    setDescription(other.getDescription());
    setWind(other.getWind());
    _branchwise->takeSettings(*other._branchwise);
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
    _simulation = std::make_shared<ForestSimulation>(std::move(description), options);
    osg::ref_ptr<BranchwiseForest> branchwise = new BranchwiseForest(_simulation);
    if (_branchwise)
        branchwise->takeSettings(*_branchwise);
    removeChild(_branchwise);
    _branchwise = branchwise;
    insertChild(0, _branchwise);
}

bool Forest::isOwnChild(const osg::Node* child) const {
    return child == _branchwise;
}

osg::Vec3d Forest::getOrigin() const {
    const glm::dvec3& origin = getDescription().origin;
    return {origin.x, origin.y, origin.z};
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
    _simulation->setWind(getWind());
    _branchwise->update(stamp.getSimulationTime());
}

} // namespace osgTreeWind
