// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/stand/LeafOrders.h>
#include <osgTreeWind/drawing/stand/TreeTiers.h>
#include <osgTreeWind/model/TreeModel.h>

#include <osg/Geometry>
#include <osg/StateSet>

#include <vector>

namespace osgTreeWind {

/// What the trees of one model are drawn from, at each tier.
class ModelResources : public osg::Referenced {
public:
    /// @param species that it is a model of.
    ModelResources(const TreeModel& model, std::size_t species, const Appearance& appearance);
    /// As another one, but drawn from these of a host at every tier; null for none.
    ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves);
    /// Its pictures need not show what they look like then.
    bool isOfHost() const { return _isOfHost; }

    /// Null where there is none, as the next one.
    osg::Geometry* bark(Tier tier) const { return _bark[static_cast<int>(tier)].get(); }
    /// @param order LeafOrders::nearest()
    osg::Geometry* leaves(Tier tier, std::size_t order) const {
        return _leaves[static_cast<int>(tier)][order].get();
    }
    /// Null before it was painted.
    const ImpostorStrip* impostor(Tier tier) const {
        return _impostors[static_cast<int>(tier) - branchTiers].get();
    }
    /// Paints the impostor of that tier. In update; different threads may paint different ones.
    void paint(Tier tier, const TreeModel& model, const Appearance& appearance, osg::Program* program);

    std::size_t species() const { return _species; }
    /// Where shaders find its poses at that tier.
    osg::StateSet* state(Tier tier) const { return _states[static_cast<int>(tier)].get(); }

    /// Adds geometries and state sets: all that OpenGL keeps something of.
    void addGLObjects(std::vector<osg::Object*>& objects) const;

private:
    std::size_t _species;
    bool _isOfHost = false;
    osg::ref_ptr<osg::Geometry> _bark[branchTiers];
    LeafOrders::Geometries _leaves[branchTiers];
    osg::ref_ptr<osg::StateSet> _states[branchTiers];
    osg::ref_ptr<ImpostorStrip> _impostors[impostorTiers];
};

} // namespace osgTreeWind
