// SPDX-License-Identifier: MIT
// osgtreewind-map [FILE...]: reads rasters, map features and coordinate systems for the library, which runs
// it and asks it one question after another, so that the library needs neither GDAL nor PROJ, and a damaged
// file ends this process and not the one that has a forest. It ends with its standard input.
#include <plugins/ReaderLimits.h>
#include <plugins/map/FeatureFile.h>
#include <plugins/map/GdalRaster.h>

#include <osgTreeWind/base/Problem.h>

#include <cpl_conv.h>
#include <gdal.h>

#include <exception>
#include <iostream>
#include <map>

#include <unistd.h>

namespace osgTreeWind {

namespace {

using Task = MapQuestion::Task;

/// Answers the questions of the library.
class MapAnswers {
public:
    explicit MapAnswers(int descriptor) : _descriptor(descriptor) {}

    /// False where nobody hears it.
    bool answer(const MapQuestion& question) {
        const std::string first = question.texts.empty() ? std::string() : question.texts[0],
                          second = question.texts.size() < 2 ? std::string() : question.texts[1];
        switch (question.task) {
        case Task::ParseCrs: {
            const auto crs = Crs::parse(first);
            return send(crs ? Result<Crs::Facts>(crs.value().facts()) : crs.problems());
        }
        case Task::CompareCrs: {
            const auto one = Crs::parse(first), other = Crs::parse(second);
            return send(Result<bool>(one && other && one.value().isSame(other.value())));
        }
        case Task::FindWay: {
            const auto way = wayFrom(first, second);
            return send(way ? Result<bool>(!way.value().staysHere()) : way.problems());
        }
        case Task::BringPlaces: {
            const auto way = wayFrom(first, second);
            if (!way)
                return send(Result<std::vector<glm::dvec2>>(way.problems()));
            std::vector<glm::dvec2> places = question.places;
            way.value().go(places);
            return send(Result<std::vector<glm::dvec2>>(std::move(places)));
        }
        case Task::DescribeMap: {
            Crs::Facts map;
            map.text = first;
            return send(gridMappingOf(Crs(map)));
        }
        case Task::ReadRaster:
            return sendRaster(first, second);
        case Task::ReadCells:
            return send(readGeoTiffCells(first));
        case Task::KnowFeatures:
            return send(Result<bool>(FeatureFile::knows(first)));
        case Task::WriteTable: {
            PointTable table;
            return Wire::receiver(_descriptor).pass(table) && send(done(writeGeoPackage(table, first)));
        }
        default:
            return answerOfFeatures(question, first, second);
        }
    }

private:
    bool answerOfFeatures(const MapQuestion& question, const std::string& first, const std::string& second) {
        switch (question.task) {
        case Task::OpenFeatures: {
            auto opened = FeatureFile::open(first);
            if (!opened)
                return send(Result<FeatureFileHead>(opened.problems()));
            _features = std::move(opened.value());
            return send(Result<FeatureFileHead>(_features.head()));
        }
        case Task::ChooseLayer:
            return send(_features.chooseLayer(first));
        case Task::RewindFeatures: {
            const auto way = first.empty() ? Result<CrsWay>(CrsWay()) : wayFrom(first, second);
            return send(way ? _features.rewind(way.value(), question.columns) : way.problems());
        }
        case Task::NextFeatures:
            return send(Result<FeatureBatch>(_features.next()));
        default:
            return false;
        }
    }

    /// Ways are kept: to find one takes long.
    Result<CrsWay> wayFrom(const std::string& from, const std::string& to) {
        const auto known = _ways.find({from, to});
        if (known != _ways.end())
            return known->second;
        const auto start = Crs::parse(from), end = Crs::parse(to);
        if (!start || !end)
            return (start ? end : start).problems();
        auto way = CrsWay::between(start.value(), end.value());
        if (way)
            _ways[{from, to}] = way.value();
        return way;
    }

    bool sendRaster(const std::string& path, const std::string& band) {
        GdalRaster raster(path, band);
        Result<RasterHead> head = raster.head();
        const bool isGood = head.ok();
        bool isTaken = send(std::move(head));
        if (isGood)
            raster.read([&](Result<std::vector<float>> rows) { return isTaken = send(std::move(rows)); });
        return isTaken;
    }

    static Result<MapDone> done(const Diagnostics& problems) {
        return problems.empty() ? Result<MapDone>(MapDone()) : problems;
    }

    template <typename T>
    bool send(Result<T> result) {
        return Wire::send<T>(_descriptor, result);
    }

    const int _descriptor;
    std::map<std::pair<std::string, std::string>, CrsWay> _ways;
    FeatureFile _features;
};

/// Answers until nobody asks any more.
bool serve(int descriptor, unsigned secondsForAnswer) {
    MapAnswers answers(descriptor);
    for (;;) {
        alarm(0); // however long nobody asks
        MapQuestion question;
        if (!Wire::receiver(descriptor).pass(question))
            return true;
        alarm(secondsForAnswer);
        if (!answers.answer(question))
            return false;
    }
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    if (isatty(STDIN_FILENO)) {
        std::cerr << "usage: osgtreewind-map [FILE...]\n"
                     "osgTreeWind reads maps with this program. It talks to the library, not to people.\n";
        return 2;
    }
    const std::vector<std::string> files(argv + 1, argv + argc);
    const unsigned seconds = limitReader(files, std::size_t(2) << 30, 300);
    CPLSetConfigOption("GDAL_CACHEMAX", "64"); // megabytes: what is read is passed on
    const int descriptor = dup(STDIN_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO); // what a library prints is no part of an answer
    try {
        _exit(serve(descriptor, seconds) ? 0 : 1); // at once: what was damaged is not tidied up
    } catch (const std::exception&) {              // no memory is left, as a rule
        _exit(1);
    }
}
