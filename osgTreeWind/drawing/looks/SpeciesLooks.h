// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// State of the trees of a species under the law `modal`.
struct SpeciesLooks {
    osg::ref_ptr<osg::StateSet> bark, leaves, impostors;
    /// State of the host, applied after the above; may be null. A program in it replaces the built-in one.
    osg::ref_ptr<osg::StateSet> hostBark, hostLeaves;
    Reconfiguration foliage;

    /// Sets the colours of a season. Replaces the state sets, because copies of this struct share them.
    void showSeason(const Appearance& appearance, float season);
};

/// Factor on the summer colour of leaves.
osg::Vec3 seasonTint(const Appearance& appearance, float season);

/// Makes new state sets with shared programs and textures.
SpeciesLooks makeSpeciesLooks(const Species& species);

} // namespace osgTreeWind
