// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/CrownSheet.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>

#include <osg/Node>

#include <utility>

namespace osgTreeWind {

/// What OSG's pager brings to a Forest from one file of a world. Draws nothing.
template <typename Content>
class FileOfTiles : public osg::Node {
public:
    explicit FileOfTiles(Content given) : content(std::move(given)) {}
    Content content;
};

using TreeTile = FileOfTiles<TileTrees>;
using CrownFile = FileOfTiles<CrownSheet>;
using IdFile = FileOfTiles<TileIds>;

/// Has osgDB read files of a world, from folders and servers: `.trees` as a TreeTile, `.crowns` as a
/// CrownFile, `.ids` as an IdFile. Thread-safe; once is enough.
void registerTileReader();

} // namespace osgTreeWind
