// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osg/Drawable>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

class ForestSimulation;

/// A tree as an intersection visitor met it: posed as it stood then, in the forest's frame. The `drawable` of
/// a hit on a tree of an InstancedForest:
///
///     if (auto* tree = dynamic_cast<const TreeHit*>(hit.drawable.get()))
///         use(tree->getTree(), tree->getUnit(hit.primitiveIndex));
class OSGTREEWIND_EXPORT TreeHit : public osg::Drawable {
public:
    TreeHit() = default;
    /// The tree in a slot of a simulation; of an empty one no tree.
    TreeHit(const ForestSimulation& simulation, std::size_t slot);
    /// A copy for osg::clone.
    TreeHit(const TreeHit& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeHit)

        /// Which tree of its forest it is.
        TreeId getTree() const {
        return _tree;
    }
    /// The unit (access order) that a triangle is part of, or whose leaf it is. @param primitive of a hit.
    unsigned getUnit(unsigned primitive) const;
    /// Whether a triangle is a leaf's.
    bool isLeaf(unsigned primitive) const { return primitive >= _barkTriangles; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override {
        return true;
    } ///< osg::Drawable: it has triangles.
    /// Hands over bark, then leaves.
    void accept(osg::PrimitiveFunctor& functor) const override;
    osg::BoundingBox computeBoundingBox() const override;       ///< osg::Drawable.
    void drawImplementation(osg::RenderInfo&) const override {} ///< Nothing is drawn.

protected:
    ~TreeHit() override = default;

private:
    TreeId _tree = noTree;
    unsigned _barkTriangles = 0;
    std::vector<unsigned> _barkEnds; ///< Of each unit in `_indices`.
    std::vector<osg::Vec3> _vertices;
    std::vector<unsigned> _indices;
    std::vector<int> _leafUnits; ///< By cluster.
};

} // namespace osgTreeWind
