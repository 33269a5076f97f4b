// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Machine.h>

#include <cstdlib>
#include <fstream>

#include <sys/utsname.h>
#include <unistd.h>

namespace osgTreeWind {

std::string hostName() {
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return name;
}

std::string processorName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (const std::size_t colon = line.find(": ");
            line.rfind("model name", 0) == 0 && colon != std::string::npos)
            return line.substr(colon + 2);
    return "unknown processor";
}

std::string systemName() {
    utsname system{};
    uname(&system);
    return std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
}

std::optional<double> machineLoad() {
    double load = 0.0;
    return getloadavg(&load, 1) == 1 ? std::optional(load) : std::nullopt;
}

double bytesRead() {
    std::ifstream file("/proc/self/io");
    std::string key;
    double bytes = 0.0;
    file >> key >> bytes;
    return bytes;
}

} // namespace osgTreeWind
