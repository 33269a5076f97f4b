// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Machine.h>
#include <osgTreeWind/system/Program.h>
#include <osgTreeWind/system/Windows.h>

namespace osgTreeWind {

std::string hostName() {
    wchar_t name[256] = {};
    DWORD size = sizeof name / sizeof *name;
    return GetComputerNameExW(ComputerNameDnsHostname, name, &size) ? toUtf8(name) : std::string();
}

std::string processorName() {
    return environmentVariable("PROCESSOR_IDENTIFIER").value_or("unknown processor");
}

std::string systemName() {
    return "Windows " + environmentVariable("PROCESSOR_ARCHITECTURE").value_or("");
}

std::optional<double> machineLoad() {
    return std::nullopt;
}

double bytesRead() {
    IO_COUNTERS counters{};
    GetProcessIoCounters(GetCurrentProcess(), &counters);
    return static_cast<double>(counters.ReadTransferCount);
}

} // namespace osgTreeWind
