// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/MapMessages.h>

#include <gdal.h>
#include <ogr_api.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A file of map features while it is read: what VectorFile asks for.
class FeatureFile {
public:
    /// Whether a file is one, by its content or extension.
    static bool knows(const std::string& path);
    static Result<FeatureFile> open(const std::string& path);

    const FeatureFileHead& head() const { return _head; }
    /// @param layer empty: the only one.
    Result<FeatureLayer> chooseLayer(const std::string& layer);
    /// Makes the first feature the next one. @param columns empty: all.
    Result<MapDone> rewind(CrsWay way, std::vector<std::size_t> columns);
    /// The next features.
    FeatureBatch next();

private:
    int count() const;
    OGRLayerH at(int index) const;
    std::string where() const;
    std::string described(const std::string& message) const;
    void add(OGRFeatureH feature, FeatureBatch& batch) const;

    std::string _path;
    FeatureFileHead _head;
    std::shared_ptr<void> _data; ///< GDALDatasetH.
    OGRLayerH _layer = nullptr;  ///< Of `_data`.
    CrsWay _way;
    std::vector<std::size_t> _columns;
};

} // namespace osgTreeWind
