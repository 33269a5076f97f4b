// SPDX-License-Identifier: MIT
// osgtreewind-weather FILE grid|stored [CRS X0 Y0 X1 Y1] [FILE]: reads NetCDF and GRIB for the library in a
// separate process, because libhdf5 can crash on damaged files.
#include <plugins/ReaderLimits.h>
#include <plugins/weather/GribWind.h>
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/windfiles/WeatherHead.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindInput.h>

#include <cpl_error.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include <unistd.h>

namespace osgTreeWind {

namespace {

Result<WindContent> readWeather(const std::string& path, const WindRequest& request) {
    try {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        const Result<std::string> head = WindInput(path).head();
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

WindRequest parseRequest(char** arguments, int count) {
    const bool hasArea = count > 2;
    WindRequest request;
    request.asStored = std::string(arguments[0]) == "stored";
    if (hasArea)
        request.area = {arguments[1],
                        {std::atof(arguments[2]), std::atof(arguments[3])},
                        {std::atof(arguments[4]), std::atof(arguments[5])}};
    if (count % 5 == 2)
        request.secondFile = arguments[count - 1];
    return request;
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    if (argc != 3 && argc != 4 && argc != 8 && argc != 9) {
        std::cerr
            << "usage: osgtreewind-weather FILE grid|stored [CRS X0 Y0 X1 Y1] [FILE]\n"
               "Used by osgTreeWind to read NetCDF and GRIB; the output is binary. To inspect a file, use "
               "`osgtreewind wind`.\n";
        return 2;
    }
    const WindRequest request = parseRequest(argv + 2, argc - 2);
    limitResources({argv[1], request.secondFile}, std::size_t(1) << 30, 10);
    const int output = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO); // keeps messages of libraries out of the output
    Result<WindContent> content = readWeather(argv[1], request);
    _exit(Wire::send(output, content) ? 0 : 1); // skips destructors, which could crash after damage
}
