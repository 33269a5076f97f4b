// SPDX-License-Identifier: MIT
// osgtreewind-weather FILE SECOND grid|stored all|CRS X0 Y0 X1 Y1 [VARIABLE]...: reads NetCDF and GRIB for
// the library in a separate process, because libhdf5 can crash on damaged files.
#include <plugins/ReaderLimits.h>
#include <plugins/weather/GribWind.h>
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Program.h>
#include <osgTreeWind/windfiles/WeatherHead.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <cpl_error.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace osgTreeWind {

namespace {

Result<WindContent> readWeather(const std::string& path, const WindRequest& request) {
    try {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        const Result<std::string> head = readHead(path, headSize);
        if (head && !isNetCdf(head.value()) && isGrib(head.value()))
            return readGribWind(path, request);
        NetCdfFile file(path, request.secondFile);
        if (!file.good())
            return file.problem();
        return isWrf(file) ? readNetCdfWrf(file, request) : readNetCdfCf(file, request);
    } catch (const std::bad_alloc&) {
        return fileProblem(path, "its wind needs more memory than there is (OSGTREEWIND_MAX_MEMORY)");
    } catch (const std::exception& error) { // thrown by libraries
        return fileProblem(path, std::string("cannot be read: ") + error.what());
    }
}

constexpr std::size_t requiredArguments = 9;

WindRequest parseRequest(const std::vector<std::string>& arguments) {
    WindRequest request;
    request.secondFile = arguments[2];
    request.asStored = arguments[3] == "stored";
    if (arguments[4] != "all")
        request.area = {arguments[4],
                        {std::atof(arguments[5].c_str()), std::atof(arguments[6].c_str())},
                        {std::atof(arguments[7].c_str()), std::atof(arguments[8].c_str())}};
    request.variable.assign(arguments.begin() + requiredArguments, arguments.end());
    return request;
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    trustOwnLibraries();
    const std::vector<std::string> arguments = programArguments(argc, argv);
    if (arguments.size() < requiredArguments) {
        std::cerr
            << "usage: osgtreewind-weather FILE SECOND grid|stored all|CRS X0 Y0 X1 Y1 [VARIABLE]...\n"
               "Used by osgTreeWind to read NetCDF and GRIB; the output is binary. To inspect a file, use "
               "`osgtreewind wind`.\n";
        return 2;
    }
    const WindRequest request = parseRequest(arguments);
    limitResources({arguments[1], request.secondFile}, std::size_t(1) << 30, 10);
    const int output = takeStandardOutput();
    Result<WindContent> content = readWeather(arguments[1], request);
    exitNow(Wire::send(output, content) && finishOutput(output)
                ? 0
                : 1); // skips destructors, which could crash after damage
}
