// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Console.h>
#include <osgTreeWind/system/Windows.h>

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <io.h>

namespace osgTreeWind {

namespace {

void (*cleanUpProgram)() = nullptr;

UINT codePageBefore = 0; // of the console, which other programs use later

void restoreCodePage() {
    if (codePageBefore != 0)
        SetConsoleOutputCP(codePageBefore);
}

DWORD WINAPI cleanUpInThread(void*) {
    cleanUpProgram();
    return 0;
}

/// Windows calls it in a thread of its own.
BOOL WINAPI endProgram(DWORD) {
    constexpr UINT interrupted = 130; // as on Linux after SIGINT
    constexpr DWORD longest = 4000;   // ms; after 5 s, Windows itself would end it
    WaitForSingleObject(CreateThread(nullptr, 0, cleanUpInThread, nullptr, 0, nullptr), longest);
    restoreCodePage();
    TerminateProcess(GetCurrentProcess(), interrupted);
    return TRUE;
}

} // namespace

void exitOnInterrupt(void (*cleanUp)()) {
    cleanUpProgram = cleanUp;
    SetConsoleCtrlHandler(endProgram, TRUE);
}

void useUtf8Console() {
    codePageBefore = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    std::atexit(restoreCodePage);
    for (std::FILE* stream : {stdout, stderr})
        _setmode(_fileno(stream), _O_BINARY);
}

} // namespace osgTreeWind
