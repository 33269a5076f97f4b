// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/CrownSheet.h>

#include <osg/Group>
#include <osg/Uniform>

#include <vector>

namespace osgTreeWind {

/// The crowns of a world's tiles as they look from afar: a picture of crowns for each cell of a sheet, turned
/// to the eye and painted by shaders/crowns.frag. They cover what the trees cover, from the side and from
/// above, but stand still: so far away a lean is less than a pixel.
class FarCrowns : public osg::Group {
public:
    /// In the forest's frame, one child a tile. @param world has tiles.
    FarCrowns(const CrownSheet& sheet, const ForestDescription& world);

    /// Whether those of a tile are drawn; all are at first. In update.
    void show(std::size_t tile, bool shown);
    /// Of the year (Season.h). In update.
    void showSeason(float season);

protected:
    ~FarCrowns() override;

private:
    std::vector<Species> _species;
    std::vector<osg::ref_ptr<osg::Node>> _tiles; ///< Null: one without crowns.
    osg::ref_ptr<osg::Uniform> _colors;          ///< By species, with the share of leaves.
};

} // namespace osgTreeWind
