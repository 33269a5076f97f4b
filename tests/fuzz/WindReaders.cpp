// SPDX-License-Identifier: MIT
#include <tests/fuzz/ReadersOfWind.h>

#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

namespace {

void readCsvWind(const std::string& bytes) {
    WindSeriesColumns columns;
    columns.time = {"time"};
    columns.speed = "speed";
    columns.direction = "direction";
    requireValid(readWindCsv(bytes, "fuzz", columns));
}

void readEsriWind(const std::string& bytes) {
    const Result<RasterBand> band = readEsriGrid(bytes, "fuzz");
    if (isRead(band))
        requireValid(windFromBands(band.value(), band.value(), "fuzz"));
}

const FuzzReaders windReaders = {
    {"Csv", readCsvWind},
    {"EsriGrid", readEsriWind},
    {"QesSensor", [](const std::string& bytes) { requireValid(readQesSensor(bytes, "fuzz")); }},
    {"Toa5", [](const std::string& bytes) { requireValid(readToa5(bytes, "fuzz", {})); }},
    {"TurbSim", [](const std::string& bytes) { requireValid(readTurbSim(bytes, "fuzz")); }},
    {"VtkLegacy", [](const std::string& bytes) { requireValid(readVtkLegacy(bytes, "fuzz")); }},
    {"VtkXml", [](const std::string& bytes) { requireValid(readVtkXml(bytes, "fuzz")); }}};

} // namespace

} // namespace osgTreeWind
