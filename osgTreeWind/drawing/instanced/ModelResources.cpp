// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelResources.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/SharedObjects.h>
#include <osgTreeWind/species/SpeciesFields.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>

namespace osgTreeWind {

ModelResources::ModelResources(const TreeModel& model, std::size_t species, const Appearance& appearance)
    : _species(species), _meshes(sharedMeshes(model, appearance)) {}

ModelResources::ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves)
    : _species(other._species), _isOfHost(true), _meshes(other._meshes), _hostBark(bark),
      _hostLeaves(leaves) {
    std::copy(std::begin(other._impostors), std::end(other._impostors), _impostors);
}

void ModelResources::paint(Tier tier, const TreeModel& model, const Appearance& appearance) {
    _impostors[static_cast<int>(tier) - branchTiers] = sharedImpostor(model, appearance, tier);
}

void ModelResources::addGLObjects(std::vector<osg::Object*>& objects) const {
    for (int tier = 0; tier < branchTiers; ++tier) {
        if (osg::Geometry* geometry = bark(static_cast<Tier>(tier)))
            objects.push_back(geometry);
        for (std::size_t order = 0; order < LeafOrders::count; ++order)
            if (osg::Geometry* geometry = leaves(static_cast<Tier>(tier), order))
                objects.push_back(geometry);
    }
    for (const osg::ref_ptr<ImpostorStrip>& impostor : _impostors)
        if (impostor)
            objects.insert(objects.end(), {impostor->geometry(), impostor->straight(), impostor->stateSet()});
}

osg::ref_ptr<ImpostorStrip> sharedImpostor(const TreeModel& model, const Appearance& appearance, Tier tier) {
    using Key = std::tuple<std::uint64_t, std::string, Tier, const osg::Program*>;
    static SharedObjects<Key, ImpostorStrip> impostors;
    const osg::ref_ptr<osg::Program> program =
        sharedProgram("impostor", "impostor"); // a host may replace its files
    const auto make = [&] {
        ImpostorSettings settings;
        settings.leaves = leavesOn(tier);
        osg::ref_ptr<ImpostorStrip> impostor =
            new ImpostorStrip(paintImpostor(model, appearance, settings), program);
        impostor->stateSet()->addUniform(new osg::Uniform("tierColor", tierColor(tier)));
        return impostor;
    };
    if (model.identity == 0)
        return make();
    std::string look;
    addFieldBytes(appearance, look);
    return impostors.get({model.identity, look, tier, program.get()}, make);
}

} // namespace osgTreeWind
