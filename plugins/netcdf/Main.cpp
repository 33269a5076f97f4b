// SPDX-License-Identifier: MIT
// osgtreewind-netcdf FILE grid|stored: reads NetCDF for the library, which runs it, so that a damaged file,
// on which libhdf5 frees wild memory, ends this process and not the one that has a forest.
#include <plugins/netcdf/NetCdfFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/windfiles/WindWire.h>

#include <cpl_error.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <sys/resource.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

Result<WindContent> read(const std::string& path, bool asStored) {
    try {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        NetCdfFile file(path);
        if (!file.good())
            return file.problem();
        const NetCdfFile::Array u = file.array("U");
        const bool staggered = u && u->dimensions.size() == 4 && u->dimensions[3].name == "west_east_stag";
        return staggered ? readNetCdfWrf(file, asStored) : readNetCdfCf(file, asStored);
    } catch (const std::exception& error) { // what the libraries below throw stops here
        return fileProblem(path, std::string("cannot be read: ") + error.what());
    }
}

/// What a damaged file may not cost: a core file, and more memory and time than a whole one would take.
void limit(const std::string& path) {
    std::error_code unknown;
    const auto found = std::filesystem::file_size(path, unknown);
    const rlim_t bytes = unknown ? 0 : found;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages; // what this program itself takes
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t(1) << 30) + 256 * bytes;
    const rlimit none{0, 0}, memory{most, most};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_AS, &memory);
    sigset_t all; // whatever those mask or ignore who start this
    sigfillset(&all);
    sigprocmask(SIG_UNBLOCK, &all, nullptr);
    signal(SIGALRM, SIG_DFL);
    alarm(60 + static_cast<unsigned>(bytes >> 20)); // seconds, one for each MiB more
}

} // namespace

} // namespace osgTreeWind

int main(int argc, char** argv) {
    using namespace osgTreeWind;
    if (argc != 3) {
        std::cerr
            << "usage: osgtreewind-netcdf FILE grid|stored\n"
               "What osgTreeWind reads NetCDF with; its answer is not for people. See `osgtreewind wind`.\n";
        return 2;
    }
    limit(argv[1]);
    Result<WindContent> content = read(argv[1], std::string(argv[2]) == "stored");
    _exit(WindWire::send(STDOUT_FILENO, content) ? 0 : 1); // at once: what was damaged is not tidied up
}
