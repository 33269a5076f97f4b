// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Forest.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/TextureCapacity.h>
#include <osgTreeWind/drawing/ground/GroundTile.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/ForestStatistics.h>
#include <osgTreeWind/nodes/FrameStep.h>
#include <osgTreeWind/nodes/ProgressNotice.h>
#include <osgTreeWind/nodes/ScenePlace.h>
#include <osgTreeWind/nodes/TilePager.h>
#include <osgTreeWind/nodes/TreeUnit.h>

#include <osg/NodeVisitor>
#include <osg/Notify>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t maxNearTrees = 500; // up to here, all trees start with the full motion of near ones

Diagnostics findProblems(const ForestDescription& description) {
    if (Diagnostics problems = check(description); !problems.empty())
        return problems;
    std::string problem = textureCapacityProblem(description);
    if (problem.empty())
        problem = problemOfMemory(description, true);
    return problem.empty() ? Diagnostics() : Diagnostics{keyProblem({}, problem)};
}

std::vector<TreeUnit> unitsOf(const MovingForest& forest, std::size_t slot) {
    const PlacedTree& tree = forest.trees()[slot];
    UnitValues values;
    const TreeMotion motion = forest.motion(slot, values);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    std::vector<TreeUnit> units;
    for (const BranchUnit& rest : forest.placed().modelOf(tree).skeleton.units) {
        const UnitPose& pose = motion.poses[units.size()];
        const auto now = [&](const glm::vec3& point) {
            return toOsg(rotateAboutZ(pose.apply(point), sine, cosine) + tree.position);
        };
        const glm::vec3 base = tree.scale.axes * rest.base, tip = tree.scale.axes * rest.tip;
        units.push_back({rest.parent, rest.level, tree.scale.radius * rest.baseRadius,
                         tree.scale.radius * rest.tipRadius, toOsg(base), toOsg(tip), now(base), now(tip)});
    }
    return units;
}

osg::ref_ptr<ForestTechnique> makeDefaultTechnique(const std::shared_ptr<ForestSimulation>& simulation) {
    if (simulation->description().law == MotionLaw::Modal)
        return new InstancedForest(simulation);
    return new BranchwiseForest(simulation);
}

} // namespace

Forest::Forest() : Forest(ForestDescription()) {}

Forest::Forest(ForestDescription description)
    : _wind(std::make_shared<WindSlot>()), _place(std::make_unique<ScenePlace>()) {
    setNumChildrenRequiringUpdateTraversal(1);
    if (const Diagnostics problems = setDescription(std::move(description)); !problems.empty()) {
        OSG_WARN << "osgTreeWind: the forest is left empty: " << toString(problems) << std::endl;
        rebuild(ForestDescription());
    }
}

Forest::Forest(const Forest& other, const osg::CopyOp& copyop)
    : osg::Group(other, copyop), _executor(other._executor), _place(std::make_unique<ScenePlace>()) {
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (other.isOwnChild(other.getChild(i)))
            removeChild(i);
    _technique = static_cast<ForestTechnique*>(other._technique->clone(copyop));
    _isHostTechnique = other._isHostTechnique;
    setSimulation(other._simulation->cloneAtRest());
    _wind = movingForest(*_simulation).wind();
    for (const TreeId tree : getTrees())
        if (movingForest(*_simulation).trees()[slotOfTree(tree)].tiled)
            unloadTree(tree); // the pager of the copy loads it again
}

Forest::~Forest() = default;

Diagnostics Forest::setWind(Wind wind) {
    return _wind->set(std::move(wind));
}

Wind Forest::getWind() const {
    return *_wind->get();
}

Diagnostics Forest::setCanopy(const CanopySettings& canopy) {
    return _simulation->setCanopy(canopy);
}

const CanopySettings& Forest::getCanopy() const {
    return _simulation->canopy();
}

void Forest::setExecutor(Executor executor) {
    _simulation->setExecutor(executor);
    _executor = std::move(executor);
}

Diagnostics Forest::setSeason(float season) {
    if (Diagnostics problems = _simulation->setSeason(season); !problems.empty())
        return problems;
    _technique->seasonChanged();
    if (_tiles)
        _tiles->seasonChanged();
    return {};
}

float Forest::getSeason() const {
    return _simulation->season();
}

const ForestDescription& Forest::getDescription() const {
    return _simulation->description();
}

Result<osg::ref_ptr<Forest>> Forest::create(ForestDescription description, Executor executor) {
    return guardedResult([&]() -> Result<osg::ref_ptr<Forest>> {
        if (Diagnostics problems = findProblems(description); !problems.empty())
            return problems;
        const osg::ref_ptr<Forest> forest = new Forest;
        forest->setExecutor(std::move(executor));
        forest->rebuild(std::move(description));
        return forest;
    });
}

Result<osg::ref_ptr<Forest>> Forest::read(const std::string& path, Executor executor) {
    return guardedResult([&]() -> Result<osg::ref_ptr<Forest>> {
        Result<ForestFile> file = readForestFile(path);
        if (!file)
            return file.problems();
        for (const std::string& note : file.value().notes)
            OSG_NOTICE << "osgTreeWind: " << path << ": " << note << std::endl;
        Result<osg::ref_ptr<Forest>> forest = create(std::move(file.value()), std::move(executor));
        if (forest)
            return forest;
        Diagnostics problems = forest.problems();
        for (Diagnostic& problem : problems)
            problem.file = path;
        return problems;
    });
}

Diagnostics Forest::setDescription(ForestDescription description) {
    return guardedResult([&]() -> Diagnostics {
        Diagnostics problems = findProblems(description);
        if (problems.empty())
            rebuild(std::move(description));
        return problems;
    });
}

void Forest::rebuild(ForestDescription description) {
    if (!description.wind.isCalm())
        _wind->set(description.wind);
    SimulationOptions options;
    options.onTreePlaced = ProgressNotice(description.trees.size());
    options.executor = _executor;
    if (description.drawing.tiers && (description.tiles || description.trees.size() > maxNearTrees))
        options.distant = true; // until they are visible
    setSimulation(std::shared_ptr<ForestSimulation>(
        new ForestSimulation(std::make_unique<MovingForest>(std::move(description), options, _wind))));
}

Diagnostics Forest::setTechnique(ForestTechnique* technique) {
    return guardedResult([&]() -> Diagnostics {
        if (technique && technique != _technique) {
            const osg::ref_ptr<ForestTechnique> given = technique;
            given->setSimulation(_simulation);
            replaceTechnique(given);
        } else if (!technique && _isHostTechnique) {
            replaceTechnique(makeDefaultTechnique(_simulation));
        }
        _isHostTechnique = technique != nullptr;
        return {};
    });
}

void Forest::replaceTechnique(const osg::ref_ptr<ForestTechnique>& technique) {
    removeChild(_technique);
    _technique = technique;
    insertChild(0, _technique);
}

void Forest::setSimulation(std::shared_ptr<ForestSimulation> simulation) {
    std::vector<osg::ref_ptr<osg::Texture2D>> textures; // held until the technique has them
    if (!movingForest(*simulation).models().empty())
        textures = treeTextures(simulation->description().species, simulation->executor());
    osg::ref_ptr<ForestTechnique> technique = _technique;
    const bool isModal = simulation->description().law == MotionLaw::Modal;
    if (technique && (_isHostTechnique || isModal == (getInstanced() != nullptr)))
        technique->setSimulation(simulation);
    else
        technique = makeDefaultTechnique(simulation);
    removeChild(_tiles);
    _tiles = nullptr;
    _hasFailed = false;
    _frameStep = frameStepOf(simulation->description());
    _guard = std::make_unique<ExceptionGuard>();
    _simulation = std::move(simulation);
    replaceTechnique(technique);
    if (getDescription().tiles) {
        _tiles = new TilePager(_simulation, [this](const TreePlacement& tree) {
            const Result<TreeId> id = addTree(tree);
            return id ? std::optional(id.value()) : std::nullopt;
        });
        insertChild(1, _tiles);
    }
    _ground = createGroundDrawing(getDescription().ground, getDescription().origin, _technique->getBound());
    _treeCount = getTrees().size();
}

Result<std::size_t> Forest::addSpecies(Species species) {
    return guardedResult([&] {
        Result<std::size_t> index = _simulation->addSpecies(std::move(species));
        if (index)
            _technique->speciesAdded();
        return index;
    });
}

Result<TreeId> Forest::addTree(const TreePlacement& placement) {
    return guardedResult([&] {
        Result<TreeId> tree = _simulation->addTree(placement);
        if (tree) {
            ++_treeCount;
            _technique->treeChanged(tree.value());
        }
        return tree;
    });
}

Diagnostics Forest::removeTree(TreeId tree) {
    Diagnostics problems = _simulation->removeTree(tree);
    if (problems.empty()) {
        --_treeCount;
        _technique->treeChanged(tree);
    }
    return problems;
}

void Forest::unloadTree(TreeId tree) {
    if (!movingForest(*_simulation).unloadTiledTree(tree).empty())
        return;
    --_treeCount;
    _technique->treeChanged(tree);
}

Diagnostics Forest::changeTree(TreeId tree, const TreePlacement& placement) {
    return guardedResult([&] {
        Diagnostics problems = _simulation->changeTree(tree, placement);
        if (problems.empty())
            _technique->treeChanged(tree);
        return problems;
    });
}

std::optional<TreeId> Forest::findTree(const std::string& name) {
    if (_tiles && !_simulation->findTree(name))
        _tiles->loadTree(name);
    return _simulation->findTree(name);
}

std::vector<TreeId> Forest::getTrees() const {
    return _simulation->trees();
}

std::optional<TreePlacement> Forest::getPlacement(TreeId tree) const {
    return _simulation->placementOf(tree);
}

std::vector<TreeUnit> Forest::getUnits(TreeId tree) const {
    if (!_simulation->holds(tree))
        return {};
    return unitsOf(movingForest(*_simulation), slotOfTree(tree));
}

std::optional<TreeSway> Forest::sway(TreeId tree) const {
    return _simulation->sway(tree);
}

void Forest::setDamageCallback(DamageCallback callback) {
    _damageCallback = std::move(callback);
}

Result<BranchTransform*> Forest::branch(TreeId tree, unsigned unit) {
    if (BranchTransform* transform = _technique->branch(tree, unit))
        return transform;
    if (!_simulation->holds(tree))
        return keyProblem("tree", "no tree has this id; it may have been removed");
    const std::size_t units = getUnits(tree).size();
    if (unit < units)
        return keyProblem("technique", "the forest's technique has no transforms that follow branches");
    return keyProblem("unit", "there is no unit " + std::to_string(unit) + "; the tree has " +
                                  std::to_string(units) + ", from 0 on");
}

bool Forest::releaseBranch(TreeId tree, unsigned unit) {
    return _technique->releaseBranch(tree, unit);
}

InstancedForest* Forest::getInstanced() const {
    return _technique->asInstancedForest();
}

BranchwiseForest* Forest::getBranchwise() const {
    return _technique->asBranchwiseForest();
}

bool Forest::isOwnChild(const osg::Node* child) const {
    return child == _technique || (child && child == _tiles);
}

osg::Vec3d Forest::getOrigin() const {
    const glm::dvec3& origin = getDescription().origin;
    return {origin.x, origin.y, origin.z};
}

void Forest::traverse(osg::NodeVisitor& visitor) {
    const osg::FrameStamp* stamp = visitor.getFrameStamp();
    const osg::ElapsedTime clock;
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR && stamp && !_hasFailed)
        _hasFailed = !_guard->run("the forest stands still until setDescription()", [&] { update(visitor); });
    const bool isCull = visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR && stamp;
    if (isCull)
        _place->setCulledFrame(stamp->getFrameNumber());
    osg::Group::traverse(visitor);
    if (isCull)
        _guard->run("the statistics of the forest are missing",
                    [&] { report(visitor, clock.elapsedTime()); });
}

void Forest::report(osg::NodeVisitor& cullVisitor, double cullTime) const {
    osg::Stats* const stats = viewStatistics(cullVisitor);
    if (!stats)
        return;
    ForestStatistics statistics{_updateDuration, cullTime, _treeCount, {}, {}};
    if (_tiles)
        statistics.tiles = _tiles->loadedTileCount();
    if (const InstancedForest* instanced = getInstanced())
        statistics.drawn = DrawnTrees(instancedTrees(*instanced).treesByTier());
    statistics.report(*stats, cullVisitor.getFrameStamp()->getFrameNumber());
}

osg::BoundingSphere Forest::computeBound() const {
    return getNumChildren() == 1 && !_tiles
               ? _technique->getBound()
               : osg::Group::computeBound(); // larger: a sphere of a sphere's box
}

/// Updates the position at which the forest samples the wind.
void Forest::updatePlace(const osg::NodePath& path) {
    _place->update(path);
    osg::Matrix toScene = _place->toScene();
    const osg::Vec3d zero = toScene.getTrans();
    if ((zero - getOrigin()).length2() < zero.length2()) // the scene is in world coordinates
        toScene.postMultTranslate(-getOrigin());
    movingForest(*_simulation).setForestToScene(glm::make_mat4(toScene.ptr()));
}

void Forest::update(osg::NodeVisitor& visitor) {
    const osg::FrameStamp& stamp = *visitor.getFrameStamp();
    const osg::NodePath& path = visitor.getNodePath();
    if (_place->isHidden(path, stamp.getFrameNumber()))
        return;
    if (stamp.getFrameNumber() == _lastFrame) {
        if (getNumParents() > 0 && _place->isNewSecondPlace(path))
            OSG_WARN << "osgTreeWind: forest \"" << getName()
                     << "\" stands in two places of the scene; both show it "
                     << "in the wind of the first place. Copy it with osg::clone() for the second"
                     << std::endl;
        return;
    }
    _lastFrame = stamp.getFrameNumber();
    const osg::ElapsedTime clock;
    updatePlace(path);
    if (_tiles) {
        const TilePager::Changes changes = _tiles->update(stamp);
        std::for_each(changes.toUnload.begin(), changes.toUnload.end(),
                      [&](TreeId tree) { unloadTree(tree); });
        _simulation->spinUp(changes.addedNearEye);
    }
    const osg::ref_ptr<osg::FrameStamp> forestStamp = new osg::FrameStamp(stamp);
    if (_frameStep > 0.0)
        forestStamp->setSimulationTime(_frameStep * stamp.getFrameNumber());
    const double time = forestStamp->getSimulationTime();
    const bool moved =
        _technique->stepsItself() ? movingForest(*_simulation).beginStep(time) : _simulation->advance(time);
    _technique->update(*forestStamp, moved);
    const std::vector<TreeDamage> damageEvents = _simulation->damage(); // a copy: callbacks may change trees
    for (const TreeDamage& damage : damageEvents)
        _technique->treeChanged(damage.tree);
    if (_damageCallback)
        std::for_each(damageEvents.begin(), damageEvents.end(), _damageCallback);
    _updateDuration = clock.elapsedTime();
}

} // namespace osgTreeWind
