// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/MapMessages.h>

#include <gdal.h>
#include <ogr_api.h>

#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// An open file of map features, which VectorFile reads through this program.
class FeatureFile {
public:
    /// Whether a file has a supported format, by its content or extension.
    static bool isSupported(const std::string& path);
    static Result<FeatureFile> open(const std::string& path);

    const FeatureFileHeader& head() const { return _head; }
    /// @param layer may be empty if the file has only one.
    Result<FeatureLayer> chooseLayer(const std::string& layer);
    /// Restarts at the first feature. @param columns empty: all. @param isYFirst as for placeOfGeometry().
    Result<MapAcknowledgement> rewind(CrsTransform transform, std::vector<std::size_t> columns,
                                      bool isYFirst);
    /// The next features.
    FeatureBatch next();

private:
    int layerCount() const;
    OGRLayerH layerAt(int index) const;
    std::string where() const;
    std::string withLayer(const std::string& message) const;
    void add(OGRFeatureH feature, FeatureBatch& batch) const;

    std::string _path;
    FeatureFileHeader _head;
    std::shared_ptr<void> _data; ///< GDALDatasetH.
    OGRLayerH _layer = nullptr;  ///< Of `_data`.
    CrsTransform _transform;
    std::vector<std::size_t> _columns;
    bool _isYFirst = false;
};

} // namespace osgTreeWind
