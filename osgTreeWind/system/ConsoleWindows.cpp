// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Console.h>
#include <osgTreeWind/system/Windows.h>

#include <cstdio>

#include <fcntl.h>
#include <io.h>

namespace osgTreeWind {

namespace {

void (*cleanUpProgram)() = nullptr;

/// Windows calls it in a thread of its own.
BOOL WINAPI endProgram(DWORD) {
    constexpr UINT interrupted = 130; // as on Linux after SIGINT
    cleanUpProgram();
    TerminateProcess(GetCurrentProcess(), interrupted);
    return TRUE;
}

} // namespace

void exitOnInterrupt(void (*cleanUp)()) {
    cleanUpProgram = cleanUp;
    SetConsoleCtrlHandler(endProgram, TRUE);
}

void useUtf8Console() {
    SetConsoleOutputCP(CP_UTF8);
    for (std::FILE* stream : {stdout, stderr})
        _setmode(_fileno(stream), _O_BINARY);
}

} // namespace osgTreeWind
