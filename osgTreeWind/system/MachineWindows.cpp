// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Machine.h>
#include <osgTreeWind/system/Windows.h>

namespace osgTreeWind {

namespace {

/// A text of the registry for the machine.
std::optional<std::string> registryText(const wchar_t* key, const wchar_t* name) {
    wchar_t text[256] = {};
    DWORD bytes = sizeof text;
    if (RegGetValueW(HKEY_LOCAL_MACHINE, key, name, RRF_RT_REG_SZ, nullptr, text, &bytes) != ERROR_SUCCESS)
        return std::nullopt;
    return toUtf8(text);
}

} // namespace

std::string hostName() {
    wchar_t name[256] = {};
    DWORD size = sizeof name / sizeof *name;
    return GetComputerNameExW(ComputerNameDnsHostname, name, &size) ? toUtf8(name) : std::string();
}

std::string processorName() {
    return registryText(L"HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0", L"ProcessorNameString")
        .value_or("unknown processor");
}

std::string systemName() {
    const wchar_t key[] = L"SOFTWARE\\Microsoft\\Windows NT\\CurrentVersion";
    return registryText(key, L"ProductName").value_or("Windows") + ' ' +
           registryText(key, L"CurrentBuildNumber").value_or("");
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
