// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/PosedTree.h>
#include <osgTreeWind/drawing/branchwise/TreeStyle.h>
#include <osgTreeWind/drawing/instanced/ModelResources.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <map>
#include <utility>

namespace osgTreeWind {

/// Pictures of far trees under a law of a branch, one for each model and share of leaves, painted when it is
/// first asked for.
class BillboardPictures {
public:
    /// What draws a tree as it looks in a season.
    osg::ref_ptr<osg::Drawable> of(const PlacedTree& tree, PosedTree& posed, const Appearance& appearance,
                                   float season);

    void resizeGLObjectBuffers(unsigned maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    struct Picture {
        osg::ref_ptr<ImpostorStrip> strip;
        osg::ref_ptr<SharedStateSet> state;
    };
    std::map<std::pair<std::size_t, Tier>, Picture> _pictures; ///< By model and share of leaves.
};

} // namespace osgTreeWind
