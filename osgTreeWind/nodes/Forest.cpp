// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Forest.h>

#include <osgTreeWind/motion/ForestMemory.h>
#include <osgTreeWind/wind/GivenWind.h>

#include <osg/ApplicationUsage>
#include <osg/LOD>
#include <osg/NodeVisitor>
#include <osg/Notify>
#include <osg/Switch>
#include <osg/Transform>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

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

constexpr std::size_t smallStand = 500; // trees; so few are followed closely from the start
constexpr unsigned framesUnseen = 2;    // below a LOD: until it counts as hidden

} // namespace

Forest::Forest() : Forest(ForestDescription()) {}

Forest::Forest(ForestDescription description) : _wind(std::make_shared<GivenWind>()) {
    setNumChildrenRequiringUpdateTraversal(1);
    setDescription(std::move(description));
}

Forest::Forest(const Forest& other, const osg::CopyOp& copyop)
    : osg::Group(other, copyop), _executor(other._executor) {
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (other.isOwnChild(other.getChild(i)))
            removeChild(i);
    show(other._simulation->restarted(), other._stand ? &other._stand->drawing() : nullptr);
    _wind = _simulation->givenWind();
    if (_branchwise)
        _branchwise->takeSettings(*other._branchwise);
}

Forest::~Forest() = default;

void Forest::setWind(WindFieldPtr wind) {
    _wind->set(std::move(wind));
}

WindFieldPtr Forest::getWind() const {
    return _wind->get();
}

void Forest::setExecutor(Executor executor) {
    _simulation->setExecutor(executor);
    _executor = std::move(executor);
}

void Forest::setSeason(float season) {
    _simulation->setSeason(season);
    if (_stand)
        _stand->seasonChanged();
    else
        _branchwise->seasonChanged();
}

void Forest::setDescription(ForestDescription description) {
    if (description.wind)
        setWind(description.wind);
    std::string problem = BranchwiseForest::problemOf(description);
    if (problem.empty())
        problem = problemOfMemory(description, true);
    if (!problem.empty()) {
        OSG_WARN << "osgTreeWind: " << problem << "; the forest is left empty" << std::endl;
        description = ForestDescription();
    }
    SimulationOptions options;
    options.placed = Patience(description.trees.size());
    options.executor = _executor;
    options.wind = _wind;
    if (description.drawing.tiers && description.trees.size() > smallStand)
        options.level = ModalLevel::Far; // until someone sees them
    show(std::make_shared<ForestSimulation>(std::move(description), options));
}

void Forest::show(std::shared_ptr<ForestSimulation> simulation, const StandResources* drawing) {
    const osg::ref_ptr<BranchwiseForest> former = _branchwise;
    for (osg::Node* node : {static_cast<osg::Node*>(_stand), static_cast<osg::Node*>(_branchwise),
                            static_cast<osg::Node*>(_followed)})
        removeChild(node);
    _stand = nullptr;
    _branchwise = nullptr;
    _followed = nullptr;
    _simulation = std::move(simulation);
    _treeCount =
        static_cast<std::size_t>(std::count_if(_simulation->trees().begin(), _simulation->trees().end(),
                                               [](const PlacedTree& tree) { return tree.alive; }));
    if (_simulation->modal()) {
        _stand = drawing ? new TreeStand(_simulation, *drawing) : new TreeStand(_simulation);
        _followed = new FollowedBranches;
        insertChild(0, _stand);
        insertChild(1, _followed);
    } else {
        _branchwise = new BranchwiseForest(_simulation);
        if (former)
            _branchwise->takeSettings(*former);
        insertChild(0, _branchwise);
    }
}

Result<TreeId> Forest::addTree(const TreePlacement& placement) {
    Result<TreeId> tree = _simulation->addTree(placement);
    if (tree) {
        ++_treeCount;
        _stand->treeChanged(_simulation->slotOf(tree.value()));
    }
    return tree;
}

Diagnostics Forest::removeTree(TreeId tree) {
    Diagnostics problems = _simulation->removeTree(tree);
    if (problems.empty()) {
        --_treeCount;
        _stand->treeChanged(_simulation->slotOf(tree));
    }
    return problems;
}

Diagnostics Forest::changeTree(TreeId tree, const TreePlacement& placement) {
    Diagnostics problems = _simulation->changeTree(tree, placement);
    if (problems.empty())
        _stand->treeChanged(_simulation->slotOf(tree));
    return problems;
}

TreeId Forest::findTree(const std::string& name) const {
    return _simulation->findTree(name).value_or(noTree);
}

BranchTransform* Forest::branch(TreeId tree, unsigned unit) {
    if (!_simulation->holds(tree))
        return nullptr;
    if (_followed) {
        BranchTransform* branch = _followed->follow(*_simulation, tree, unit);
        if (branch)
            _stand->keepNear(_simulation->slotOf(tree));
        return branch;
    }
    return _branchwise->getTree(static_cast<unsigned>(_simulation->slotOf(tree)))->getBranch(unit);
}

void Forest::setBarkState(std::size_t species, osg::StateSet* state) {
    if (_stand && species < getDescription().species.size())
        _stand->drawing().looks[species].ownBark = state;
}

void Forest::setLeafState(std::size_t species, osg::StateSet* state) {
    if (_stand && species < getDescription().species.size())
        _stand->drawing().looks[species].ownLeaves = state;
}

void Forest::setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves) {
    if (_stand && model < _simulation->models().size()) {
        osg::ref_ptr<ModelResources>& shape = _stand->drawing().shapes[model];
        shape = new ModelResources(*shape, bark, leaves);
    }
}

bool Forest::isOwnChild(const osg::Node* child) const {
    return child == _stand || child == _branchwise || child == _followed;
}

osg::Vec3d Forest::getOrigin() const {
    const glm::dvec3& origin = getDescription().origin;
    return {origin.x, origin.y, origin.z};
}

void Forest::traverse(osg::NodeVisitor& visitor) {
    const osg::FrameStamp* stamp = visitor.getFrameStamp();
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR && stamp)
        update(visitor);
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR && stamp)
        _culledFrame = stamp->getFrameNumber();
    osg::Group::traverse(visitor);
}

/// Update visitors enter what a Switch or LOD hides, too.
bool Forest::isHidden(const osg::NodePath& path, unsigned frame) const {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (auto* choice = dynamic_cast<osg::Switch*>(path[i]))
            if (!choice->getChildValue(path[i + 1]))
                return true;
        if (dynamic_cast<osg::LOD*>(path[i]) && _culledFrame != ~0u && frame > _culledFrame + framesUnseen)
            return true;
    }
    return false;
}

/// Tells the wind where the forest is.
void Forest::stand(const osg::NodePath& path) {
    _place = osg::computeLocalToWorld(path);
    osg::Matrix toScene = _place;
    const osg::Vec3d stands = _place.getTrans();
    if ((stands - getOrigin()).length2() < stands.length2()) // the scene is in world coordinates
        toScene.postMultTranslate(-getOrigin());
    _wind->setPlace(glm::make_mat4(toScene.ptr()));
}

void Forest::update(osg::NodeVisitor& visitor) {
    const osg::FrameStamp& stamp = *visitor.getFrameStamp();
    const osg::NodePath& path = visitor.getNodePath();
    if (isHidden(path, stamp.getFrameNumber()))
        return;
    if (stamp.getFrameNumber() == _lastFrame) {
        if (!_twoPlaces && getNumParents() > 0 && osg::computeLocalToWorld(path) != _place) {
            _twoPlaces = true;
            OSG_WARN << "osgTreeWind: forest \"" << getName()
                     << "\" stands in two places of the scene; both show it "
                     << "in the wind of the first. A copy (osg::clone) would have its own" << std::endl;
        }
        return;
    }
    _lastFrame = stamp.getFrameNumber();
    stand(path);
    if (_branchwise) {
        _branchwise->update(stamp.getSimulationTime());
        return;
    }
    _simulation->advance(stamp.getSimulationTime());
    _stand->update(stamp.getFrameNumber(), stamp.getSimulationTime());
    _followed->update(*_simulation);
}

} // namespace osgTreeWind
