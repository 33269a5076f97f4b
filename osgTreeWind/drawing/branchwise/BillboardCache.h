// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/PosedTree.h>
#include <osgTreeWind/drawing/branchwise/TreeStyle.h>
#include <osgTreeWind/drawing/instanced/ModelResources.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <map>
#include <utility>

namespace osgTreeWind {

/// Billboards of distant trees under a branchwise law, by model and share of leaves, painted on first use.
class BillboardCache {
public:
    /// @return a drawable that shows the billboard of a tree in the colours of a season.
    osg::ref_ptr<osg::Drawable> makeDrawable(const PlacedTree& tree, PosedTree& posed,
                                             const Appearance& appearance, float season);

    void resizeGLObjectBuffers(unsigned maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    struct Picture {
        osg::ref_ptr<ImpostorStrip> strip;
        osg::ref_ptr<SharedStateSet> state;
    };
    std::map<std::pair<std::size_t, Tier>, Picture> _pictures; ///< By model and impostor tier.
};

} // namespace osgTreeWind
