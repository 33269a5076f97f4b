// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/CrownSummary.h>

#include <osg/Group>
#include <osg/Uniform>

#include <vector>

namespace osgTreeWind {

/// Draws the crowns of the tiles of a world that are far away: a billboard of crowns for each cell of a
/// sheet, painted by shaders/crowns.frag. Billboards cover as much as the trees do from the side and from
/// above. They do not move, since the sway is less than a pixel at that distance.
class FarCrowns : public osg::Group {
public:
    /// One child for each tile, in the forest's frame. @param world must have tiles.
    FarCrowns(const CrownSummary& summary, const ForestDescription& world);

    /// All tiles are visible at first. In update.
    void setTileVisible(std::size_t tile, bool visible);
    /// Sets the colours of a season (Season.h). In update.
    void showSeason(float season);

protected:
    ~FarCrowns() override;

private:
    std::vector<Species> _species;
    std::vector<osg::ref_ptr<osg::Node>> _tiles; ///< Null for a tile without crowns.
    osg::ref_ptr<osg::Uniform> _colors;          ///< By species: colour and share of leaves.
};

} // namespace osgTreeWind
