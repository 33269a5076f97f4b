// SPDX-License-Identifier: MIT
#include <plugins/map/OpenOptions.h>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <atomic>
#include <string_view>

namespace osgTreeWind {

namespace {

/// The tags of nodes that are columns, in the form of GDAL's osmconf.ini.
constexpr std::string_view osmTags = "[points]\n"
                                     "osm_id=yes\n"
                                     "attributes=natural,species,taxon,genus,height,circumference,diameter,"
                                     "diameter_crown,ref,name,denotation,leaf_type,leaf_cycle,start_date\n";

} // namespace

OpenOptions::OpenOptions(const std::string& format) {
    if (format == "GML")
        _list = CSLSetNameValue(_list, "WRITE_GFS", "NO"); // nothing beside other people's files
    if (format != "OSM")
        return;
    static std::atomic<unsigned> count{0};
    _osmTags = "/vsimem/osgTreeWind/osm" + std::to_string(count++) + ".ini";
    VSILFILE* file = VSIFOpenL(_osmTags.c_str(), "wb");
    VSIFWriteL(osmTags.data(), 1, osmTags.size(), file);
    VSIFCloseL(file);
    _list = CSLSetNameValue(_list, "CONFIG_FILE", _osmTags.c_str());
}

OpenOptions::~OpenOptions() {
    CSLDestroy(_list);
    if (!_osmTags.empty())
        VSIUnlink(_osmTags.c_str());
}

} // namespace osgTreeWind
