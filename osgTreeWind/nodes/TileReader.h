// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>

#include <osg/Node>

#include <utility>

namespace osgTreeWind {

/// A node that carries the content of one file of a tiled forest through OSG's pager. It draws nothing.
template <typename Content>
class TileFileNode : public osg::Node {
public:
    explicit TileFileNode(Content given) : content(std::move(given)) {}
    Content content;
};

using TreeTile = TileFileNode<TileTrees>;
using CrownFile = TileFileNode<CrownSummary>;
using IdFile = TileFileNode<TileIds>;

/// Registers an osgDB reader for the files of tiled forests, in folders and on servers: `.trees` as TreeTile,
/// `.crowns` as CrownFile, `.ids` as IdFile. Thread-safe; further calls have no effect.
void registerTileReader();

} // namespace osgTreeWind
