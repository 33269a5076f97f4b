// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeTile.h>

#include <osgTreeWind/io/TileTrees.h>

#include <utility>

namespace osgTreeWind {

TreeTile::TreeTile() : _trees(std::make_shared<TileTrees>()) {}

TreeTile::TreeTile(const TreeTile& other, const osg::CopyOp& copyop)
    : osg::Node(other, copyop), _trees(std::make_shared<TileTrees>(*other._trees)) {}

TreeTile::~TreeTile() = default;

Result<osg::ref_ptr<TreeTile>> TreeTile::read(std::istream& input, const std::string& file) {
    Result<TileTrees> trees = readTileTrees(input, file);
    if (!trees)
        return trees.problems();
    const osg::ref_ptr<TreeTile> tile = new TreeTile;
    tile->setName(file);
    *tile->_trees = std::move(trees.value());
    return tile;
}

Result<std::vector<TreePlacement>> TreeTile::take(const std::vector<Species>& species, std::size_t count,
                                                  const std::string& file) {
    Diagnostics problems = _trees->fit(species, count, file);
    if (!problems.empty())
        return problems;
    return std::exchange(_trees->trees, {});
}

} // namespace osgTreeWind
