// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Program.h>
#include <osgTreeWind/system/Windows.h>

#include <algorithm>
#include <cstdlib>

#include <psapi.h>
#include <shellapi.h>

namespace osgTreeWind {

namespace {

std::filesystem::path pathOf(HMODULE module) {
    std::wstring path(32768, L'\0'); // the longest path
    path.resize(GetModuleFileNameW(module, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

/// The library or program that contains this function.
HMODULE ownModule(DWORD flags) {
    static const char symbol = 0;
    HMODULE module = nullptr;
    GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | flags, reinterpret_cast<LPCWSTR>(&symbol),
                       &module);
    return module;
}

} // namespace

const char programSuffix[] = ".exe";
const char listSeparator = ';';
const std::int64_t threadTimeStep = 15'625'000;

std::filesystem::path programPath() {
    return pathOf(nullptr);
}

std::filesystem::path libraryPath() {
    return pathOf(ownModule(GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT));
}

std::vector<std::string> programArguments(int, char**) { // argv lacks characters outside of the code page
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> arguments;
    for (int i = 0; i < count; ++i)
        arguments.push_back(toUtf8(words[i]));
    LocalFree(words);
    return arguments;
}

std::optional<std::string> environmentVariable(const char* name) {
    std::wstring value(32768, L'\0'); // the longest value
    SetLastError(ERROR_SUCCESS);
    value.resize(
        GetEnvironmentVariableW(toWide(name).c_str(), value.data(), static_cast<DWORD>(value.size())));
    return GetLastError() == ERROR_ENVVAR_NOT_FOUND ? std::nullopt : std::optional(toUtf8(value));
}

std::filesystem::path cacheFolder() {
    return toPath(environmentVariable("LOCALAPPDATA").value_or(""));
}

std::string monospaceFontFile() {
    return environmentVariable("SystemRoot").value_or("") + "/Fonts/consola.ttf";
}

std::int64_t processId() {
    return GetCurrentProcessId();
}

bool hasEnded(std::int64_t process) {
    const HANDLE handle = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
    if (!handle)
        return GetLastError() == ERROR_INVALID_PARAMETER; // no such process
    const bool hasEnded = WaitForSingleObject(handle, 0) == WAIT_OBJECT_0;
    CloseHandle(handle);
    return hasEnded;
}

std::int64_t threadTime() {
    FILETIME start{}, end{}, inSystem{}, inProgram{};
    GetThreadTimes(GetCurrentThread(), &start, &end, &inSystem, &inProgram);
    const auto hundreds = [](const FILETIME& time) {
        return std::int64_t(time.dwHighDateTime) << 32 | std::int64_t(time.dwLowDateTime);
    };
    return 100 * (hundreds(inSystem) + hundreds(inProgram));
}

void trustOwnLibraries() {
    SetDllDirectoryW(L"");
}

void runInstead(const std::filesystem::path&) {} // one program has all backends

void exitNow(int status) {
    TerminateProcess(GetCurrentProcess(), static_cast<UINT>(status));
    std::abort(); // not reached
}

void* findFunction(const char* name) {
    HMODULE modules[1024];
    DWORD bytes = 0;
    K32EnumProcessModules(GetCurrentProcess(), modules, sizeof modules, &bytes);
    for (std::size_t i = 0; i < std::min<std::size_t>(bytes, sizeof modules) / sizeof(HMODULE); ++i)
        if (const FARPROC function = GetProcAddress(modules[i], name))
            return reinterpret_cast<void*>(function);
    return nullptr;
}

bool endsThreadsFirst() {
    ownModule(GET_MODULE_HANDLE_EX_FLAG_PIN);
    return true;
}

} // namespace osgTreeWind
