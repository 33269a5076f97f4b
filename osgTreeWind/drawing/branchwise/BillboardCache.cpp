// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/BillboardCache.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/drawing/looks/SpeciesLooks.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>

namespace osgTreeWind {
namespace {

/// Draws a tree as an ImpostorStrip that faces the eye and does not move (thesis §7).
class BillboardDrawable : public TreeDrawable {
public:
    /// @param treeRandom random number of the tree, [0, 1).
    BillboardDrawable(osg::Geometry* geometry, PosedTree* tree, float treeRandom)
        : TreeDrawable("BillboardDrawable", geometry, tree), _treeRandom(treeRandom) {}
    void drawImplementation(osg::RenderInfo& renderInfo) const override {
        const TreeScale& scale = _tree->scale();
        const auto* gl = renderInfo.getState()->get<osg::GLExtensions>();
        gl->glVertexAttrib4f(treePlaceLocation, 0.0f, 0.0f, 0.0f, 0.0f);
        gl->glVertexAttrib4f(treeSizeLocation, scale.axes.x, scale.axes.z, 0.0f, 0.0f);
        gl->glVertexAttrib4f(treeStateLocation, 0.0f, 0.0f, 1.0f, _treeRandom);
        gl->glVertexAttrib4f(treeLightLocation, 1.0f, 1.0f, 0.0f, 0.0f);
        TreeDrawable::drawImplementation(renderInfo);
    }

protected:
    Triangles posedTriangles() const override { return {}; } // cannot be picked

private:
    float _treeRandom;
};

} // namespace

osg::ref_ptr<osg::Drawable> BillboardCache::makeDrawable(const PlacedTree& tree, PosedTree& posed,
                                                         const Appearance& appearance, float season) {
    const Tier tier = impostorTier(tree.leaves);
    auto found = _pictures.find({tree.model, tier});
    if (found == _pictures.end()) {
        Picture made;
        made.strip = sharedImpostor(posed.model(), appearance, tier);
        made.state = new SharedStateSet(*made.strip->stateSet());
        made.state->addUniform(new osg::Uniform("leanPower", 1.0f)); // without effect: the lean is 0
        found = _pictures.emplace(std::pair(tree.model, tier), made).first;
    }
    const Picture& picture = found->second;
    if (tier != Tier::BareImpostor) // twigs have no leaf tint
        picture.state->getOrCreateUniform("leafTint", osg::Uniform::FLOAT_VEC3)
            ->set(seasonTint(appearance, season));
    osg::ref_ptr<osg::Drawable> drawable =
        new BillboardDrawable(picture.strip->geometry(), &posed, Random(tree.seed).uniform());
    drawable->setStateSet(picture.state);
    return drawable;
}

void BillboardCache::resizeGLObjectBuffers(unsigned maxSize) {
    for (const auto& [key, picture] : _pictures)
        picture.strip->geometry()->resizeGLObjectBuffers(maxSize);
}

void BillboardCache::releaseGLObjects(osg::State* state) const {
    for (const auto& [key, picture] : _pictures) {
        picture.strip->geometry()->releaseGLObjects(state);
        picture.state->releaseShared(state);
    }
}

} // namespace osgTreeWind
