// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/ModelResources.h>
#include <osgTreeWind/drawing/looks/SpeciesLooks.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/gpu/PosePass.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// What instanced trees are drawn from, made on the threads of their simulation. A copy shares all of
/// it.
struct InstancedResources {
    explicit InstancedResources(const ForestSimulation& simulation);
    /// Whether a simulation has the same species and models, in the same season.
    bool areOf(const ForestSimulation& simulation) const;

    /// Makes what species and models lack that were added. In update.
    void addSpecies(const ForestSimulation& simulation);
    /// Has leaves the colour of the season, and all impostors that its trees need. In update.
    void followSeason(const ForestSimulation& simulation);
    /// The same for one tree.
    void paintImpostor(const ForestSimulation& simulation, const PlacedTree& tree);

    std::vector<osg::ref_ptr<ModelResources>> models; ///< By model.
    std::vector<SpeciesLooks> looks;                  ///< By species.
    osg::ref_ptr<osg::StateSet> state;                ///< Of all trees with branches.
    osg::ref_ptr<osg::StateSet> fading;               ///< Of trees that cross over to another tier.
    osg::ref_ptr<PosePrograms> programs;

    /// Programs, geometries and state sets: all that OpenGL keeps something of.
    std::vector<osg::Object*> glObjects() const;

private:
    SharedModels _shapes; ///< Whose models these are.
    std::string _species; ///< Bytes of the fields of the species.
    float _season = 0.0f;

    using Pictures = std::set<std::pair<std::size_t, Tier>>; ///< By model.
    /// Those of them that are not painted yet.
    void paintImpostors(const ForestSimulation& simulation, const Pictures& wanted);
};

} // namespace osgTreeWind
