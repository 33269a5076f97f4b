// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <osg/Node>
#include <osg/NodeVisitor>
#include <osg/ref_ptr>

#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

struct TileTrees;

/// The trees of one tile (ForestTiles) as OSG's pager brings them to a Forest. Draws nothing.
class TreeTile : public osg::Node {
public:
    TreeTile();
    TreeTile(const TreeTile& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeTile)

        /// What a file of a tile holds, or what is wrong with it, at which line. Thread-safe.
        static Result<osg::ref_ptr<TreeTile>> read(std::istream& input, const std::string& file);

    /// Empties it. @param species the world's. @param count of trees that the tile has. @param file its name.
    /// @return the trees, as TileTrees::fit() has them; or what does not fit.
    Result<std::vector<TreePlacement>> take(const std::vector<Species>& species, std::size_t count,
                                            const std::string& file);

protected:
    ~TreeTile() override;

private:
    std::shared_ptr<TileTrees> _trees;
};

} // namespace osgTreeWind
