// SPDX-License-Identifier: MIT
// Readers of the program osgtreewind-weather.
#include <tests/fuzz/ReadersOfWind.h>

#include <plugins/ReaderLimits.h>
#include <plugins/weather/GribChoice.h>
#include <plugins/weather/GribWind.h>
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/windfiles/WeatherHead.h>

#include <cpl_error.h>

#include <array>
#include <cmath>
#include <csignal>
#include <exception>
#include <fstream>
#include <optional>

#include <sys/socket.h>
#include <sys/wait.h>

namespace osgTreeWind {

namespace {

void readGribMessages(const std::string& bytes) {
    const auto fields = readGribFields(bytes, "fuzz");
    if (!isRead(fields))
        return;
    for (const GribField& field : fields.value())
        require(!field.parts.empty() && std::isfinite(field.valid) && std::isfinite(field.level.value));
    const auto choice = chooseGribWind(fields.value(), "fuzz", {});
    if (!isRead(choice))
        return;
    const std::size_t count = choice.value().times.size() * choice.value().levels.size();
    require(count > 0 && choice.value().east.size() == count && choice.value().north.size() == count);
    for (const GribField* field : choice.value().allFields())
        require(field);
}

void readFile() {
    try {
        if (const auto head = readHead(fuzzFile(), headSize); head && isGrib(head.value()))
            return requireValid(readGribWind(fuzzFile(), {}));
        NetCdfFile file(fuzzFile(), {});
        if (file.good())
            requireValid(isWrf(file) ? readNetCdfWrf(file, {}) : readNetCdfCf(file, {}));
    } catch (const std::exception&) { // no memory, or thrown by libraries
    }
}

/// A process that reads, because libraries can crash on damaged files.
class ReadingProcess {
public:
    ReadingProcess() {
        std::array<int, 2> ends{};
        require(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
        _process = fork();
        require(_process >= 0);
        _end = ends[_process == 0];
        close(ends[_process != 0]);
        if (_process == 0)
            serve();
    }
    ReadingProcess(const ReadingProcess&) = delete;
    ReadingProcess& operator=(const ReadingProcess&) = delete;
    ~ReadingProcess() {
        close(_end);
        int status = 0;
        waitpid(_process, &status, 0);
        require(!(WIFSIGNALED(status) && WTERMSIG(status) == SIGILL));
    }

    /// @return false if the process has ended.
    bool read() const {
        char answer = 0;
        return send(_end, &answer, 1, MSG_NOSIGNAL) == 1 && recv(_end, &answer, 1, 0) == 1;
    }

private:
    [[noreturn]] void serve() const {
        for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGILL})
            std::signal(signal, SIG_DFL);
        CPLPushErrorHandler(CPLQuietErrorHandler);
        for (char request = 0; recv(_end, &request, 1, 0) == 1; send(_end, &request, 1, MSG_NOSIGNAL)) {
            limitResources({fuzzFile()}, std::size_t(1) << 30, 10);
            readFile();
        }
        _exit(0);
    }

    pid_t _process = 0;
    int _end = 0;
};

void readWeather(const std::string& bytes) {
    std::ofstream(fuzzFile(), std::ios::binary) << bytes;
    static std::optional<ReadingProcess> process;
    if (!process)
        process.emplace();
    if (!process->read())
        process.reset();
}

const FuzzReaders weatherReaders = {
    {"Grib", readWeather}, {"GribMessages", readGribMessages}, {"NetCdf", readWeather}};

} // namespace

} // namespace osgTreeWind
