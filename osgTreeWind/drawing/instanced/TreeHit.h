// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osg/Drawable>

#include <cstddef>
#include <optional>
#include <vector>

namespace osgTreeWind {

class ForestSimulation;

/// A tree that an intersection visitor has tested, in its pose at that time, in the forest's frame. It is the
/// `drawable` of a hit on a tree of an InstancedForest:
///
///     if (auto* tree = dynamic_cast<const TreeHit*>(hit.drawable.get()))
///         use(*tree->getTree(), tree->getUnit(hit.primitiveIndex));
class OSGTREEWIND_EXPORT TreeHit : public osg::Drawable {
public:
    TreeHit() = default;
    /// Poses a tree of a simulation. Empty for an unknown tree.
    TreeHit(const ForestSimulation& simulation, TreeId tree);
    /// A copy for osg::clone.
    TreeHit(const TreeHit& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeHit)

    std::optional<TreeId> getTree() const { return _tree; } ///< The id in the forest; none for an empty hit.
    /// The branch unit (access order) of a triangle, or of the leaf of a triangle.
    /// @param primitive index of the triangle: `primitiveIndex` of the hit.
    unsigned getUnit(unsigned primitive) const;
    /// Whether a triangle belongs to a leaf.
    bool isLeaf(unsigned primitive) const { return primitive >= _barkTriangles; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; } ///< osg::Drawable.
    /// Passes the triangles of the bark, then those of the leaves.
    void accept(osg::PrimitiveFunctor& functor) const override;
    osg::BoundingBox computeBoundingBox() const override;       ///< osg::Drawable.
    void drawImplementation(osg::RenderInfo&) const override {} ///< Draws nothing.

protected:
    ~TreeHit() override = default;

private:
    std::optional<TreeId> _tree;
    unsigned _barkTriangles = 0;
    std::vector<unsigned> _barkEnds; ///< By unit: end of its bark in `_indices`.
    std::vector<osg::Vec3> _vertices;
    std::vector<unsigned> _indices;
    std::vector<int> _leafUnits; ///< By leaf cluster.
};

} // namespace osgTreeWind
