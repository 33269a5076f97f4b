// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedResources.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/LeafFall.h>
#include <osgTreeWind/motion/modal/ModalLean.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <functional>

namespace osgTreeWind {
namespace {

/// Adds the impostors that show a model with the leaves that the season leaves, or the wind may leave, on it.
void addNeededImpostors(const ForestSimulation& simulation, std::size_t model, const LeafFall& leaves,
                        float summerLeaves, std::set<std::pair<std::size_t, Tier>>& needed) {
    const auto picture = [&](float ahead) {
        return static_cast<int>(
            impostorTier(summerLeaves * leaves.remainingShare(simulation.season(), ahead)));
    };
    const float maxAdvance = simulation.description().damage ? LeafFall::maxAdvance : 0.0f;
    for (int tier = picture(0.0f); tier <= picture(maxAdvance); ++tier)
        needed.emplace(model, static_cast<Tier>(tier));
}

/// Runs jobs on the simulation's threads, which it starts only for several jobs.
void runFew(const ForestSimulation& simulation, std::size_t count,
            const std::function<void(std::size_t)>& job) {
    if (count == 1)
        job(0);
    else if (count > 1)
        runJobs(simulation.executor(), count, job);
}

std::string bytesOf(const std::vector<Species>& all) {
    std::string bytes;
    for (const Species& species : all)
        addKeyBytes(species, bytes);
    return bytes;
}

} // namespace

InstancedResources::InstancedResources(const ForestSimulation& simulation)
    : state(new osg::StateSet), hostArrays(new osg::StateSet), programs(new PosePrograms) {
    state->setDefine("FADING");
    hostArrays->setDefine("HOST_ARRAYS");
    state->addUniform(new osg::Uniform("leanPower", leanPower));
    state->addUniform(new osg::Uniform("poseRotations", static_cast<int>(PosePass::rotationsUnit)));
    state->addUniform(new osg::Uniform("poseTranslations", static_cast<int>(PosePass::translationsUnit)));
    state->addUniform(new osg::Uniform("posePulls", static_cast<int>(PosePass::pullsUnit)));
    addSpecies(simulation);
}

bool InstancedResources::matches(const ForestSimulation& simulation) const {
    return _season == simulation.season() && _shapes == movingForest(simulation).models() &&
           _species == bytesOf(simulation.description().species);
}

void InstancedResources::addSpecies(const ForestSimulation& simulation) {
    const std::vector<Species>& all = simulation.description().species;
    for (std::size_t i = looks.size(); i < all.size(); ++i)
        looks.push_back(makeSpeciesLooks(all[i]));
    _species = bytesOf(all);
    _shapes = movingForest(simulation).models();
    models.resize(_shapes.size());
    std::set<std::size_t> needed;
    for (const PlacedTree& tree : movingForest(simulation).trees())
        if (tree.alive)
            needed.insert(tree.model);
    if (simulation.description().tiles) // frames that load trees shall not wait
        for (std::size_t model = 0; model < models.size(); ++model)
            needed.insert(model);
    makeModels(simulation, needed);
    updateSeason(simulation);
}

void InstancedResources::makeModels(const ForestSimulation& simulation, const std::set<std::size_t>& needed) {
    std::vector<std::size_t> missing;
    for (const std::size_t model : needed)
        if (!models[model])
            missing.push_back(model);
    const auto make = [&](std::size_t i) {
        const std::size_t model = missing[i];
        const std::size_t species = movingForest(simulation).placed().speciesOfModel(model);
        models[model] =
            new ModelResources(_shapes[model], species, simulation.description().species[species].appearance);
    };
    runFew(simulation, missing.size(), make);
}

void InstancedResources::updateSeason(const ForestSimulation& simulation) {
    _season = simulation.season();
    const std::vector<Species>& species = simulation.description().species;
    for (std::size_t i = 0; i < looks.size(); ++i)
        looks[i].showSeason(species[i].appearance, simulation.season());
    std::vector<LeafFall> leaves;
    for (const Species& each : species)
        leaves.emplace_back(each);
    ImpostorKeys needed;
    for (std::size_t model = 0; model < models.size(); ++model) // for trees that are added later
        if (models[model])
            addNeededImpostors(simulation, model, leaves[models[model]->species()], 1.0f, needed);
    for (const PlacedTree& tree : movingForest(simulation).trees())
        if (tree.alive)
            addNeededImpostors(simulation, tree.model, leaves[tree.species], tree.summerLeaves, needed);
    paintImpostors(simulation, needed);
}

void InstancedResources::prepareTree(const ForestSimulation& simulation, const PlacedTree& tree) {
    makeModels(simulation, {tree.model});
    ImpostorKeys needed;
    addNeededImpostors(simulation, tree.model, LeafFall(movingForest(simulation).placed().speciesOf(tree)),
                       tree.summerLeaves, needed);
    paintImpostors(simulation, needed);
}

void InstancedResources::paintImpostors(const ForestSimulation& simulation, const ImpostorKeys& needed) {
    const DrawingOptions& drawing = simulation.description().drawing;
    std::vector<std::pair<std::size_t, Tier>> missing;
    for (const auto& [model, tier] : needed)
        if (drawing.tiers && drawing.impostor > 0.0f && !models[model]->impostor(tier))
            missing.emplace_back(model, tier);
    const auto paint = [&](std::size_t i) {
        const auto [model, tier] = missing[i];
        models[model]->loadImpostor(tier, *movingForest(simulation).models()[model],
                                    simulation.description().species[models[model]->species()].appearance);
    };
    runFew(simulation, missing.size(), paint);
}

std::vector<osg::Object*> InstancedResources::glObjects() const {
    std::vector<osg::Object*> objects = {programs->turns, programs->poses};
    for (const osg::ref_ptr<ModelResources>& model : models)
        if (model)
            model->addGLObjects(objects);
    for (const SpeciesLooks& look : looks)
        for (const osg::ref_ptr<osg::StateSet>& set :
             {look.bark, look.leaves, look.impostors, look.hostBark, look.hostLeaves})
            if (set)
                objects.push_back(set);
    return objects;
}

} // namespace osgTreeWind
