// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/Folders.h>
#include <tests/FullTests.h>
#include <tests/MessageCollector.h>
#include <tests/RandomValues.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/controls/ForestHandler.h>
#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/forest/StandOnGround.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/nodes/TreeUnit.h>
#include <osgTreeWind/places/FunctionGround.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/StreamedWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <osg/ComputeBoundsVisitor>
#include <osgGA/GUIActionAdapter>
#include <osgViewer/View>

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

using namespace osgTreeWind;

namespace {

class ArbitraryWind : public WindField {
public:
    explicit ArbitraryWind(RandomValues& any) : _velocity(any.vector<float>()) {}
    glm::vec3 velocity(const WindPlace&, double) const override { return _velocity; }

private:
    glm::vec3 _velocity;
};

/// A host that calls random functions of the public headers with random, often invalid, arguments.
class AnyCalls {
public:
    explicit AnyCalls(unsigned seed) : any(seed), _forest(new Forest(smallForest(3))) {
        _view->setSceneData(_forest);
        _view->getCamera()->setViewport(0, 0, 640, 480);
        _view->setFrameStamp(new osg::FrameStamp);
    }

    void call() {
        const auto& all = calls();
        auto chosen = all.begin();
        std::advance(chosen, any.below(all.size()));
        const std::vector<Call>& ofHeader = chosen->second;
        _header = chosen->first;
        (this->*ofHeader[any.below(ofHeader.size())])();
        expectSound();
    }

    using Call = void (AnyCalls::*)();
    /// By the public header that declares the called functions.
    static const std::map<std::string, std::vector<Call>>& calls() {
        using C = AnyCalls;
        static const std::map<std::string, std::vector<Call>> all = {
            {"nodes/Forest.h",
             {&C::describe, &C::create, &C::setWind, &C::setSeason, &C::addSpecies, &C::addTree, &C::addTree,
              &C::changeTree, &C::changeTree, &C::removeTree, &C::findTree, &C::queryTrees, &C::follow,
              &C::setExecutor, &C::setDamageCallback, &C::update, &C::update}},
            {"nodes/TreeUnit.h", {&C::findUnit}},
            {"motion/damage/BranchLoad.h", {&C::readSway}},
            {"motion/damage/TreeSway.h", {&C::readSway}},
            {"motion/ForestSimulation.h", {&C::simulate, &C::advance}},
            {"motion/SimulationOptions.h", {&C::simulate}},
            {"forest/StandOnGround.h", {&C::standOnItsGround}},
            {"forest/CheckForest.h", {&C::create}},
            {"places/Ground.h", {&C::queryGround}},
            {"places/FunctionGround.h", {&C::queryGround}},
            {"drawing/BranchTransform.h", {&C::turnBranch}},
            {"drawing/ForestTechnique.h", {&C::useTechnique, &C::setTechnique}},
            {"drawing/instanced/InstancedForest.h", {&C::useInstanced}},
            {"drawing/instanced/TreeHit.h", {&C::hit}},
            {"drawing/branchwise/BranchwiseForest.h", {&C::useBranchwise}},
            {"drawing/branchwise/TreeLodRanges.h", {&C::useBranchwise}},
            {"controls/ForestHandler.h", {&C::handle}},
            {"model/ScannedTree.h", {&C::joinScan}},
            {"species/Season.h", {&C::setSeason}},
            {"wind/UniformWind.h", {&C::setUniformWind}},
            {"wind/FunctionWind.h", {&C::setFunctionWind}},
            {"wind/WindGusts.h", {&C::setGusts}},
            {"wind/LogProfile.h", {&C::setGusts, &C::setSeries}},
            {"wind/ThesisWind.h", {&C::setThesisGrid}},
            {"wind/GridWind.h", {&C::setGrid, &C::setThesisGrid}},
            {"wind/StreamedWind.h", {&C::stream}},
            {"wind/TimeSeriesWind.h", {&C::setSeries}},
            {"wind/WindDirection.h", {&C::readDirection}},
            {"wind/WindSource.h", {&C::addSources}},
            {"wind/Wind.h", {&C::setWind}},
            {"wind/WindClock.h", {&C::setWind}},
            {"wind/WindAdjustment.h", {&C::setWind}},
        };
        return all;
    }

    int refused = 0, accepted = 0;

private:
    void expect(const Diagnostics& problems) {
        for (const Diagnostic& problem : problems)
            EXPECT_FALSE(problem.message.empty()) << _header;
        ++(problems.empty() ? accepted : refused);
    }
    template <typename T>
    bool expect(const Result<T>& result) {
        expect(result.problems());
        return result.ok();
    }
    /// Checks that a rejected call changed nothing.
    void expectChange(const Diagnostics& problems, const ForestDescription& before) {
        expect(problems);
        if (problems.empty())
            return;
        const ForestDescription now = _forest->getSimulation().currentDescription();
        EXPECT_EQ(now.species.size(), before.species.size()) << toString(problems);
        EXPECT_EQ(now.wind.field, before.wind.field) << toString(problems);
        EXPECT_EQ(now.season, before.season) << toString(problems);
        ASSERT_EQ(now.trees.size(), before.trees.size()) << toString(problems);
        for (std::size_t i = 0; i < now.trees.size(); ++i)
            for (const Key& each : keysOf<TreePlacement>())
                EXPECT_TRUE(isKeyEqual(each, &now.trees[i], &before.trees[i])) << toString(problems);
    }
    void expectSound() {
        const osg::BoundingSphere& sphere = _forest->getBound();
        ASSERT_TRUE(!sphere.valid() ||
                    (std::isfinite(sphere.radius()) && std::isfinite(sphere.center().length())))
            << _header;
        osg::ComputeBoundsVisitor bounds;
        _forest->accept(bounds);
        const osg::BoundingBox& box = bounds.getBoundingBox();
        ASSERT_TRUE(!box.valid() || std::isfinite(box.radius())) << _header;
        if (_simulation)
            expectFinite(*_simulation);
        expectFinite(_forest->getSimulation());
    }
    void expectFinite(const ForestSimulation& simulation) {
        UnitValues values;
        for (const UnitPose& pose : simulation.motion(TreeId(any.below(4)), values).poses)
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(std::isfinite(pose.apply(glm::vec3(1.0f))[i])) << _header;
    }

    TreeId tree() {
        const std::vector<TreeId> trees = _forest->getTrees();
        return trees.empty() || any.oneIn(4) ? TreeId(any.oneIn(2) ? any.below(5) : ~any.below(5))
                                             : trees[any.below(trees.size())];
    }
    unsigned unit() { return any.oneIn(3) ? any.count() : static_cast<unsigned>(any.below(16)); }
    TreePlacement placement() {
        TreePlacement place = smallForest(4).trees[any.below(4)];
        const std::size_t species = _forest->getDescription().species.size();
        place.species = any.oneIn(6) ? any.count() : any.below(std::max<std::size_t>(1, species));
        if (any.oneIn(3))
            place.position[static_cast<int>(any.below(3))] = any.number<double>();
        if (any.oneIn(2))
            any.corrupt(place);
        return place;
    }
    Species species() {
        Species kind = smallSpecies();
        kind.name = any.oneIn(5) ? any.text() : "kind " + std::to_string(_kinds++);
        const auto maybe = [&](auto& part) {
            if (any.oneIn(6))
                any.corrupt(part);
        };
        maybe(kind);
        maybe(kind.tree.wood);
        maybe(kind.tree.leaves);
        if (any.oneIn(4)) {
            PalmParameters& palm = kind.tree.palm.emplace();
            palm.fronds = 4;
            maybe(palm);
        }
        if (any.oneIn(6)) {
            GrowthParameters& growth = kind.tree.growth.emplace();
            growth.size = {4.0f, 0.1f, 3.0f};
            maybe(growth);
        }
        if (any.oneIn(6))
            kind.tree.scans = scans();
        return kind;
    }
    std::shared_ptr<const std::vector<ScannedTree>> scans() {
        std::vector<ScannedTree> all(any.below(3));
        for (ScannedTree& scan : all)
            if (Result<ScannedTree> joined = makeScannedTree({{{0, 0, 0}, {0, 0, 5}, 0.1, -1, 0}});
                joined && any.oneIn(2)) {
                scan = joined.value();
                BranchUnit& trunk = scan.skeleton.units.front();
                if (any.oneIn(2))
                    trunk.parent = any.integer();
                if (any.oneIn(2))
                    trunk.tip[static_cast<int>(any.below(3))] = any.number<float>();
                if (any.oneIn(2))
                    scan.skeleton.ringsPerBranch = any.integer();
            }
        return std::make_shared<const std::vector<ScannedTree>>(std::move(all));
    }
    ForestTiles tiles() {
        ForestTiles some;
        some.size = any.oneIn(2) ? 100.0 : any.number<double>();
        some.range = any.oneIn(2) ? 100.0 : any.number<double>();
        some.corner.x = any.oneIn(2) ? 0.0 : any.number<double>();
        some.columns = any.oneIn(2) ? 1 : any.count();
        some.tiles.resize(any.below(4));
        for (ForestTiles::Tile& tile : some.tiles)
            tile.high = any.oneIn(2) ? 10.0f : any.number<float>();
        return some;
    }
    GroundPtr ground() {
        if (any.oneIn(4))
            return std::make_shared<FunctionGround>(nullptr);
        GroundArea area;
        area.cell = any.oneIn(2) ? 10.0 : any.number<double>();
        area.low.x = any.oneIn(2) ? -100.0 : any.number<double>();
        area.high = {any.oneIn(2) ? 100.0 : any.number<double>(), 100.0};
        const double height = any.number<double>();
        return std::make_shared<FunctionGround>([height](double, double) { return height; }, area);
    }
    ForestDescription description() {
        ForestDescription forest = smallForest(static_cast<int>(any.below(4)));
        if (any.oneIn(3))
            forest.species = {species()};
        if (any.oneIn(8))
            forest.species.clear();
        if (any.oneIn(3) && !forest.trees.empty())
            forest.trees.back() = placement();
        if (any.oneIn(4))
            forest.origin = any.vector<double>();
        if (any.oneIn(3))
            any.corrupt(forest);
        if (any.oneIn(4))
            any.corrupt(forest.drawing);
        if (any.oneIn(4))
            any.corrupt(forest.canopy);
        if (any.oneIn(6))
            forest.noiseExponent = any.number<float>();
        if (any.oneIn(6))
            forest.season = any.number<float>();
        if (any.oneIn(8))
            forest.wind.frame = static_cast<WindFrame>(any.integer());
        if (any.oneIn(8))
            forest.tiles = tiles();
        if (any.oneIn(4))
            forest.ground = ground();
        return forest;
    }

    // Forest
    void describe() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->setDescription(description()), before);
    }
    void create() {
        const ForestDescription given = description();
        if (const Result<osg::ref_ptr<Forest>> made = Forest::create(given); expect(made)) {
            EXPECT_TRUE(check(given).empty());
            _forest = made.value();
            _view->setSceneData(_forest);
        }
        osg::ref_ptr<Forest> built = new Forest(given);
        EXPECT_LE(built->getNumTrees(), given.trees.size());
    }
    void setWind() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        const WindFieldPtr wind = any.oneIn(3) ? nullptr : std::make_shared<ArbitraryWind>(any);
        Wind given(wind, static_cast<WindFrame>(any.oneIn(2) ? any.integer() : int(any.below(3))));
        if (any.oneIn(3))
            expect(_forest->setCanopy(anyCanopy()));
        given.clock = {any.number<double>(), any.number<double>()};
        given.clock.travel = {any.number<double>(), any.number<double>()};
        given.clock.origin = {any.number<double>(), any.number<double>()};
        given.adjustment = {any.number<double>(), any.number<float>()};
        expectChange(_forest->setWind(given), before);
    }
    CanopySettings anyCanopy() {
        CanopySettings canopy;
        any.corrupt(canopy);
        return canopy;
    }
    void setSeason() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->setSeason(any.number<float>()), before);
        EXPECT_TRUE(std::isfinite(wrapSeason(any.number<float>())));
        EXPECT_TRUE(std::isfinite(leafShare(Appearance(), any.number<float>())));
    }
    void addSpecies() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->addSpecies(species()).problems(), before);
    }
    void addTree() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->addTree(placement()).problems(), before);
    }
    void changeTree() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->changeTree(tree(), placement()), before);
    }
    void removeTree() {
        const ForestDescription before = _forest->getSimulation().currentDescription();
        expectChange(_forest->removeTree(tree()), before);
    }
    void findTree() { EXPECT_FALSE(_forest->findTree(any.text() + "?")); }
    void queryTrees() {
        _forest->getPlacement(tree());
        _forest->getUnits(tree());
        EXPECT_FALSE(_forest->isOwnChild(nullptr));
    }
    void follow() {
        const TreeId id = tree();
        const unsigned at = unit();
        if (const Result<BranchTransform*> branch = _forest->branch(id, at); expect(branch))
            branch.value()->addChild(new osg::Group);
        if (any.oneIn(2))
            _forest->releaseBranch(any.oneIn(2) ? id : tree(), any.oneIn(2) ? at : unit());
    }
    void setExecutor() { _forest->setExecutor(any.oneIn(2) ? Executor() : Executor(runInTurn)); }
    void setDamageCallback() {
        if (any.oneIn(2))
            _forest->setDamageCallback(nullptr);
        else
            _forest->setDamageCallback(
                [this](const TreeDamage& damage) { expect(_forest->removeTree(damage.tree)); });
    }
    double nextTime() { return ++_frame / 25.0; }
    void update() {
        const double time = nextTime();
        ::update(*_forest, _frame, any.oneIn(4) ? any.number<double>() : time);
    }
    void findUnit() {
        std::vector<TreeUnit> units(any.below(3));
        for (TreeUnit& each : units)
            each.tip.x() = any.number<float>();
        EXPECT_EQ(nearestUnit(units, osg::Vec3(any.number<float>(), 0.0f, 0.0f)).has_value(), !units.empty());
    }

    void readSway() {
        if (const auto sway = _forest->sway(tree())) {
            EXPECT_TRUE(std::isfinite(sway->moment() + sway->frequency + sway->limit)) << _header;
            EXPECT_TRUE(std::isfinite(glm::length(sway->displacement) + glm::length(sway->velocity)));
        }
        for (const BranchLoad& load : _forest->getSimulation().branchLoads(tree()))
            EXPECT_TRUE(std::isfinite(glm::length(load.moment) + load.limit + load.strain)) << _header;
    }

    // Simulation and ground
    void simulate() {
        SimulationOptions options;
        options.leaves = any.oneIn(2);
        options.distant = any.oneIn(2);
        _simulation = std::make_unique<ForestSimulation>(description(), options);
    }
    void advance() {
        if (!_simulation)
            return;
        _simulation->advance(any.oneIn(2) ? any.number<double>() : nextTime());
        _simulation->spinUp({TreeId(0), TreeId(any.count()), tree()});
        expect(_simulation->setSeason(any.number<float>()));
        expect(_simulation->addSpecies(species()));
        expect(_simulation->addTree(placement()));
        expect(_simulation->changeTree(tree(), placement()));
        expect(_simulation->removeTree(tree()));
        EXPECT_TRUE(
            _simulation->setWind(any.oneIn(2) ? nullptr : std::make_shared<ArbitraryWind>(any)).empty());
        _simulation->setExecutor(nullptr);
        expect(_simulation->setCanopy(anyCanopy()));
        const TreeId asked = any.oneIn(2) ? tree() : TreeId(any.count());
        _simulation->motion(asked);
        _simulation->unitMotion(asked, any.count());
        _simulation->scaleOf(asked);
        EXPECT_EQ(_simulation->modelOf(asked).has_value(), _simulation->holds(asked));
        EXPECT_EQ(_simulation->placementOf(asked).has_value(), _simulation->holds(asked));
        if (any.oneIn(3))
            _simulation->reset();
    }
    void standOnItsGround() {
        ForestDescription forest = description();
        expect(standOnGround(forest, {any.below(3), any.count()}));
    }
    void queryGround() {
        const GroundPtr asked = ground();
        const std::optional<double> foot =
            footHeight(*asked, {any.number<double>(), any.number<double>()}, any.number<double>());
        EXPECT_TRUE(!foot || std::isfinite(*foot));
    }

    void joinScan() {
        ScanCylinders cylinders = {{{0, 0, 0}, {0, 0, 3}, 0.1, -1, 0}, {{0, 0, 3}, {1, 0, 5}, 0.05, 0, 0}};
        ScanCylinder& one = cylinders[any.below(2)];
        (any.oneIn(2) ? one.start : one.end)[static_cast<int>(any.below(3))] = any.number<double>();
        if (any.oneIn(2))
            one.parent = any.integer();
        if (any.oneIn(2))
            one.radius = any.number<double>();
        if (any.oneIn(4))
            cylinders.clear();
        expect(makeScannedTree(cylinders, {any.integer(), any.count(), any.number<double>()}));
    }

    // Drawing
    void turnBranch() {
        if (const Result<BranchTransform*> branch = _forest->branch(tree(), unit()))
            branch.value()->setRotation(
                osg::Quat(any.number<double>(), any.number<double>(), any.number<double>(), 1.0));
        osg::ref_ptr<BranchTransform> own =
            new BranchTransform(any.count(), osg::Vec3(any.number<float>(), any.number<float>(), 1.0f));
        own->setRotation(osg::Quat(any.number<double>(), osg::X_AXIS));
        EXPECT_FALSE(own->getMatrix().isNaN());
    }
    void useTechnique() {
        ForestTechnique* technique = _forest->getTechnique();
        technique->treeChanged(any.oneIn(2) ? tree() : TreeId(any.count()));
        technique->releaseBranch(tree(), unit());
        const osg::ref_ptr<ForestTechnique> copy = osg::clone(technique);
        copy->seasonChanged();
        copy->treeChanged(TreeId(any.count()));
        copy->setSimulation(any.oneIn(3) ? nullptr : std::make_shared<ForestSimulation>(description()));
        copy->branch(tree(), unit());
        copy->releaseBranch(tree(), unit());
    }
    void setTechnique() {
        osg::ref_ptr<ForestTechnique> technique;
        if (any.oneIn(2))
            technique = any.oneIn(2) ? new ForestTechnique : osg::clone(_forest->getTechnique());
        expect(_forest->setTechnique(any.oneIn(4) ? _forest->getTechnique() : technique.get()));
    }
    void useInstanced() {
        osg::ref_ptr<InstancedForest> own = new InstancedForest(std::shared_ptr<ForestSimulation>());
        InstancedForest* instanced = _forest->getInstanced() ? _forest->getInstanced() : own.get();
        const osg::ref_ptr<osg::StateSet> state = any.oneIn(2) ? nullptr : new osg::StateSet;
        const osg::ref_ptr<osg::Geometry> bark = any.oneIn(2) ? nullptr : new osg::Geometry;
        instanced->setBarkState(any.count(), state);
        instanced->setLeafState(any.below(2), state);
        instanced->setGeometry(any.oneIn(2) ? any.below(3) : any.count(), bark, nullptr);
    }
    void hit() {
        const osg::ref_ptr<TreeHit> met =
            new TreeHit(_forest->getSimulation(), any.oneIn(2) ? tree() : TreeId(any.count()));
        met->getUnit(any.count());
        met->isLeaf(any.count());
    }
    void useBranchwise() {
        osg::ref_ptr<BranchwiseForest> own = new BranchwiseForest(std::shared_ptr<ForestSimulation>());
        BranchwiseForest* trees = _forest->getBranchwise() ? _forest->getBranchwise() : own.get();
        expect(trees->setLodRanges({any.number<float>(), any.number<float>()}));
        trees->setAngleSource(any.oneIn(2) ? BranchwiseForest::CPU_ANGLES : BranchwiseForest::GPU_ANGLES);
        trees->getTree(any.count());
    }
    void handle() {
        osg::ref_ptr<ForestHandler> handler = new ForestHandler(any.oneIn(4) ? nullptr : _forest.get());
        handler->simulationTime(any.number<double>());
        EXPECT_TRUE(std::isfinite(handler->simulationTime(any.number<double>())));
        for (int i = 0; i < 5; ++i) {
            osg::ref_ptr<osgGA::GUIEventAdapter> event = new osgGA::GUIEventAdapter;
            const osgGA::GUIEventAdapter::EventType types[] = {
                osgGA::GUIEventAdapter::KEYDOWN, osgGA::GUIEventAdapter::FRAME, osgGA::GUIEventAdapter::PUSH,
                osgGA::GUIEventAdapter::RELEASE};
            event->setEventType(types[any.below(4)]);
            event->setKey(any.oneIn(4) ? any.integer() : static_cast<int>(any.below(128)));
            event->setButton(osgGA::GUIEventAdapter::LEFT_MOUSE_BUTTON);
            event->setTime(any.number<double>());
            event->setX(any.number<float>());
            event->setY(any.number<float>());
            handler->handle(*event, *_view);
        }
        _forest->removeChildren(1, 0);
    }

    // Winds
    void blow(const Wind& given) {
        ASSERT_TRUE(given.field || given.sources.size() < 4) << _header;
        const WindFieldPtr wind = asField(given);
        for (int i = 0; wind && i < 3; ++i) {
            const float x = i == 0 ? 1.0f : 1000.0f;
            const glm::vec3 v = wind->velocity(WindPlace(x, 2.0f, 10.0f), i == 2 ? 1e9 : 0.5);
            ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) << _header;
        }
        if (wind)
            wind->velocity(WindPlace(any.vector<float>(), any.number<float>()), any.number<double>());
        expect(_forest->setWind(given));
        const double time = nextTime();
        ::update(*_forest, _frame, time);
    }
    void setUniformWind() { blow(std::make_shared<UniformWind>(any.vector<float>())); }
    void setFunctionWind() {
        const glm::vec3 v = any.vector<float>();
        blow(any.oneIn(4) ? std::make_shared<FunctionWind>(nullptr)
                          : std::make_shared<FunctionWind>([v](const glm::vec3&, double) { return v; }));
    }
    LogProfile profile() {
        return {any.oneIn(2) ? 10.0 : any.number<double>(), any.oneIn(2) ? 0.1 : any.number<double>()};
    }
    void setGusts() {
        Wind wind(std::make_shared<UniformWind>(any.vector<float>(), profile()));
        any.corrupt(wind.gusts);
        blow(wind);
    }
    GridWind::Grid grid() {
        GridWind::Grid all;
        all.points = {2, 2, 1};
        all.values.assign(12, 1.0f);
        if (any.oneIn(3))
            any.corrupt(all);
        if (any.oneIn(3))
            all.heights = {any.number<float>()};
        return all;
    }
    void setGrid() {
        if (const auto wind = GridWind::create(grid()); expect(wind))
            blow(wind.value());
    }
    void setThesisGrid() {
        std::vector<float> values(12, 1.0f);
        if (any.oneIn(2))
            values[any.below(12)] = any.number<float>();
        const auto wind = GridWind::fromForestWind(any.oneIn(2) ? 2 : any.integer(),
                                                   any.oneIn(2) ? 2 : any.integer(), std::move(values),
                                                   any.oneIn(2) ? glm::dvec3(0.0) : any.vector<double>());
        if (expect(wind))
            blow(wind.value());
    }
    void stream() {
        const auto wind = StreamedWind::create(grid());
        if (!expect(wind))
            return;
        for (int i = 0; i < 3; ++i) {
            std::vector<float> values(any.oneIn(2) ? 12 : any.below(100000), 1.0f);
            StreamedWind::Update update{values};
            if (any.oneIn(4))
                update.velocities = {nullptr, any.below(20)};
            if (any.oneIn(2))
                update.origin = any.vector<double>();
            if (any.oneIn(2))
                update.time = any.number<double>();
            expect(wind.value()->update(update));
        }
        blow(wind.value());
    }
    void setSeries() {
        WindSeries series;
        series.times = {0.0, 1.0};
        series.velocities.assign(2, glm::vec3(1.0f));
        if (any.oneIn(2))
            any.corrupt(series);
        if (any.oneIn(3))
            series.profile = profile();
        if (const auto wind = TimeSeriesWind::create(series); expect(wind))
            blow(wind.value());
    }
    void readDirection() {
        const glm::vec3 velocity =
            windVelocity({any.number<double>(), any.number<double>()}, DirectionSense::From);
        windReading(velocity, DirectionSense::Toward);
    }
    void addSources() {
        std::vector<WindSource> sources(any.below(4));
        for (WindSource& source : sources) {
            source.kind = static_cast<WindSource::Kind>(any.below(6));
            any.corrupt(source);
        }
        Wind wind;
        wind.sources = sources;
        blow(wind);
    }

    RandomValues any;
    osg::ref_ptr<Forest> _forest;
    osg::ref_ptr<osgViewer::View> _view = new osgViewer::View;
    std::unique_ptr<ForestSimulation> _simulation;
    std::string _header;
    unsigned _frame = 0;
    int _kinds = 0;
};

std::set<std::string> publicHeaders() {
    std::ifstream list(OSGTREEWIND_SOURCE_DIR "/cmake/PublicHeaders.cmake");
    std::set<std::string> headers;
    for (std::string line; std::getline(list, line);)
        if (const std::size_t at = line.find("osgTreeWind/"); at != std::string::npos)
            headers.insert(line.substr(at + 12, line.find(".h") + 2 - at - 12));
    return headers;
}

} // namespace

TEST(AnyCallsTest, RandomInvalidCallsReturnProblemsAndBreakNothing) {
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "300M");
    const ScopedMessages messages;
    std::ostringstream standardError; // gtest's capture would hide the output of sanitizers
    std::streambuf* const console = std::cerr.rdbuf(standardError.rdbuf());
    AnyCalls host(41);
    for (int i = 0; i < casesToRun(10000, 500) && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        host.call();
    }
    std::cerr.rdbuf(console);
    EXPECT_GT(host.refused, host.accepted / 10);
    EXPECT_GT(host.accepted, host.refused / 10);
}

/// Lists the headers without calls here, with the reason.
TEST(AnyCallsTest, EveryPublicHeaderIsCoveredOrExempt) {
    std::set<std::string> known = {
        // Values, which the functions that take them check.
        "base/Result.h", "base/Span.h", "base/Executor.h", "forest/DrawingOptions.h",
        "forest/ForestDescription.h", "forest/ForestTiles.h", "forest/TreeId.h", "growth/GrowthGoal.h",
        "growth/GrowthParameters.h", "growth/GrowthSite.h", "growth/TreeHabit.h", "model/PalmParameters.h",
        "model/Skeleton.h", "model/TreeParameters.h", "model/TreeSize.h", "motion/damage/TreeDamage.h",
        "motion/laws/TreeMotion.h", "species/Appearance.h", "species/Species.h", "wind/CanopySettings.h",
        "wind/PlaceInStand.h", "wind/WindField.h", "wind/WindPlace.h", "windfiles/WindSeriesColumns.h",
        // Macros.
        "base/Export.h", "base/Version.h",
        // Files: tests/io, tests/windfiles and tests/fuzz read damaged ones.
        "io/ForestFile.h", "io/ForestStream.h", "io/SpeciesCatalogue.h", "io/TiledForest.h",
        "windfiles/WindExtent.h", "windfiles/WindFile.h",
        // It starts the program for maps: tests/plugins.
        "places/HostMap.h",
        // Context or viewer needed: tests/offscreen, ForestStatisticsGlTest.
        "offscreen/FrameImage.h", "offscreen/OffscreenContext.h", "controls/StatisticsLines.h"};
    for (const auto& [header, calls] : AnyCalls::calls())
        known.insert(header);
    EXPECT_EQ(known, publicHeaders());
}
