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

/// Geometry, programs and state of instanced trees, created on the simulation's threads. Copies share them.
struct InstancedResources {
    explicit InstancedResources(const ForestSimulation& simulation);
    /// Whether a simulation has the same species and models and the same season.
    bool matches(const ForestSimulation& simulation) const;

    /// Creates the resources of added species, and of their models that have trees. In update.
    void addSpecies(const ForestSimulation& simulation);
    /// Sets the leaf colours of the season and paints the impostors that the trees need. In update.
    void updateSeason(const ForestSimulation& simulation);
    /// Creates what one tree needs: the resources of its model, and its impostors. In update.
    void prepareTree(const ForestSimulation& simulation, const PlacedTree& tree);
    /// Creates the resources of models that have none yet. In update.
    void makeModels(const ForestSimulation& simulation, const std::set<std::size_t>& needed);

    std::vector<osg::ref_ptr<ModelResources>> models; ///< By model; null until a tree needs it.
    std::vector<SpeciesLooks> looks;                  ///< By species.
    osg::ref_ptr<osg::StateSet> state;                ///< Of all trees.
    osg::ref_ptr<osg::StateSet> hostArrays;           ///< Of geometry with vertex arrays from a host.
    osg::ref_ptr<PosePrograms> programs;

    /// All programs, geometries and state sets, which have OpenGL objects.
    std::vector<osg::Object*> glObjects() const;

private:
    SharedModels _shapes; ///< The models of the simulation.
    std::string _species; ///< Bytes of the fields of the species.
    float _season = 0.0f;

    using ImpostorKeys = std::set<std::pair<std::size_t, Tier>>; ///< Model and tier.
    /// Paints the impostors that are missing.
    void paintImpostors(const ForestSimulation& simulation, const ImpostorKeys& needed);
};

} // namespace osgTreeWind
