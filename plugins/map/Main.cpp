// SPDX-License-Identifier: MIT
// osgtreewind-map [FILE...]: reads rasters, map features and coordinate systems for the library, which runs
// it and sends requests to its standard input. The library thus needs neither GDAL nor PROJ, and a damaged
// file can crash only this process. It exits at the end of its standard input.
#include <plugins/ReaderLimits.h>
#include <plugins/map/FeatureFile.h>
#include <plugins/map/GdalRaster.h>
#include <plugins/map/GeometryPlace.h>
#include <plugins/map/Udunits.h>

#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/ProcessLimits.h>
#include <osgTreeWind/system/Program.h>

#include <cpl_conv.h>
#include <gdal.h>

#include <exception>
#include <iostream>
#include <map>

namespace osgTreeWind {

namespace {

using Task = MapRequest::Task;

/// Answers the requests of the library.
class MapServer {
public:
    explicit MapServer(int descriptor) : _descriptor(descriptor) {}

    /// @return false if the answer could not be sent.
    bool answer(const MapRequest& request) {
        const std::string first = request.texts.empty() ? std::string() : request.texts[0],
                          second = request.texts.size() < 2 ? std::string() : request.texts[1];
        switch (request.task) {
        case Task::ParseCrs: {
            const auto crs = Crs::parse(first);
            return send(crs ? Result<Crs::Facts>(crs.value().facts()) : crs.problems());
        }
        case Task::CompareCrs: {
            const auto one = Crs::parse(first), other = Crs::parse(second);
            return send(Result<bool>(one && other && one.value().isSame(other.value())));
        }
        case Task::FindTransform: {
            const auto transform = findTransform(first, second);
            return send(transform ? Result<bool>(!transform.value().isIdentity()) : transform.problems());
        }
        case Task::TransformPoints: {
            const auto transform = findTransform(first, second);
            if (!transform)
                return send(Result<std::vector<glm::dvec2>>(transform.problems()));
            std::vector<glm::dvec2> places = request.places;
            transform.value().apply(places);
            return send(Result<std::vector<glm::dvec2>>(std::move(places)));
        }
        case Task::ReadGeometries: {
            const auto transform = transformOrIdentity(first, second);
            if (!transform)
                return send(Result<GeometryBatch>(transform.problems()));
            const std::vector<std::string> cells(request.texts.begin() + 2, request.texts.end());
            return send(Result<GeometryBatch>(placesOfTexts(cells, transform.value(), request.isYFirst)));
        }
        case Task::DescribeGridMapping: {
            Crs::Facts map;
            map.text = first;
            return send(gridMappingOf(Crs(map)));
        }
        case Task::ReadRaster:
            return sendRaster(first, second);
        case Task::ReadBand:
            return send(readGeoTiffBand(first));
        case Task::DetectFeatures:
            return send(Result<bool>(FeatureFile::isSupported(first)));
        case Task::WriteTable: {
            PointTable table;
            return Wire::receiver(_descriptor).transfer(table) && send(done(writeGeoPackage(table, first)));
        }
        case Task::SizeOfUnit:
            return send(Result<double>(sizeByUdunits(first, second)));
        default:
            return answerFeatureRequest(request, first, second);
        }
    }

private:
    bool answerFeatureRequest(const MapRequest& request, const std::string& first,
                              const std::string& second) {
        switch (request.task) {
        case Task::OpenFeatures: {
            auto opened = FeatureFile::open(first);
            if (!opened)
                return send(Result<FeatureFileHeader>(opened.problems()));
            _features = std::move(opened.value());
            return send(Result<FeatureFileHeader>(_features.head()));
        }
        case Task::ChooseLayer:
            return send(_features.chooseLayer(first));
        case Task::RewindFeatures: {
            const auto transform = transformOrIdentity(first, second);
            return send(transform ? _features.rewind(transform.value(), request.columns, request.isYFirst)
                                  : transform.problems());
        }
        case Task::NextFeatures:
            return send(Result<FeatureBatch>(_features.next()));
        default:
            return false;
        }
    }

    Result<CrsTransform> transformOrIdentity(const std::string& from, const std::string& to) {
        return from.empty() ? Result<CrsTransform>(CrsTransform()) : findTransform(from, to);
    }

    /// Caches the transforms, as PROJ takes long to find them.
    Result<CrsTransform> findTransform(const std::string& from, const std::string& to) {
        const auto known = _transforms.find({from, to});
        if (known != _transforms.end())
            return known->second;
        const auto start = Crs::parse(from), end = Crs::parse(to);
        if (!start || !end)
            return (start ? end : start).problems();
        auto transform = CrsTransform::between(start.value(), end.value());
        if (transform)
            _transforms[{from, to}] = transform.value();
        return transform;
    }

    bool sendRaster(const std::string& path, const std::string& band) {
        GdalRaster raster(path, band);
        Result<RasterHeader> head = raster.head();
        const bool isGood = head.ok();
        bool isSent = send(std::move(head));
        if (isGood)
            raster.read([&](Result<std::vector<float>> rows) { return isSent = send(std::move(rows)); });
        return isSent;
    }

    static Result<MapAcknowledgement> done(const Diagnostics& problems) {
        return problems.empty() ? Result<MapAcknowledgement>(MapAcknowledgement()) : problems;
    }

    template <typename T>
    bool send(Result<T> result) {
        return Wire::send<T>(_descriptor, result);
    }

    const int _descriptor;
    std::map<std::pair<std::string, std::string>, CrsTransform> _transforms;
    FeatureFile _features;
};

/// Answers requests until the library closes the connection.
bool serve(int descriptor, unsigned secondsPerAnswer) {
    MapServer server(descriptor);
    for (;;) {
        limitTime(0); // none while waiting
        MapRequest request;
        if (!Wire::receiver(descriptor).transfer(request))
            return true;
        limitTime(secondsPerAnswer);
        if (!server.answer(request))
            return false;
    }
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    trustOwnLibraries();
    if (isInputTyped()) {
        std::cerr << "usage: osgtreewind-map [FILE...]\n"
                     "osgTreeWind runs this program to read maps. It is not for direct use.\n";
        return 2;
    }
    std::vector<std::string> files = programArguments(argc, argv);
    files.erase(files.begin());
    const unsigned seconds = limitResources(files, std::size_t(2) << 30, 300);
    CPLSetConfigOption("GDAL_CACHEMAX", "64");   // megabytes: few, as data are not read twice
    const int descriptor = takeStandardOutput(); // and input: both are one connection
    try {
        exitNow(serve(descriptor, seconds) ? 0 : 1); // without destructors, which damaged data may crash
    } catch (const std::exception&) {                // usually std::bad_alloc
        exitNow(1);
    }
}
