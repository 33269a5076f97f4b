// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/ChildProcess.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Windows.h>

#include <cerrno>
#include <cstdio>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <io.h>

namespace osgTreeWind {

namespace {

/// Quotes a word as the C runtime and CommandLineToArgvW() undo it.
std::wstring quoted(const std::wstring& word) {
    std::wstring text = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == L'"')
            text.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        text += c;
    }
    return text.append(backslashes, L'\\') + L'"';
}

/// What the exception means that ended a process.
std::string exceptionText(DWORD status) {
    switch (status) {
    case EXCEPTION_ACCESS_VIOLATION:
        return "access violation";
    case EXCEPTION_STACK_OVERFLOW:
        return "stack overflow";
    case EXCEPTION_INT_DIVIDE_BY_ZERO:
        return "division by zero";
    default:
        char text[32];
        std::snprintf(text, sizeof text, "exception %08lx", status);
        return text;
    }
}

/// A handle that child processes may inherit; closed by the destructor.
class InheritedHandle {
public:
    explicit InheritedHandle(const wchar_t* file, DWORD access) {
        SECURITY_ATTRIBUTES inherit{sizeof inherit, nullptr, TRUE};
        _handle = CreateFileW(file, access, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherit, OPEN_EXISTING, 0,
                              nullptr);
    }
    /// Copies a standard handle, or opens NUL if the process has no such handle.
    explicit InheritedHandle(DWORD standard) : InheritedHandle(L"NUL", GENERIC_WRITE) {
        HANDLE copy = nullptr;
        const HANDLE own = GetStdHandle(standard);
        if (own && own != INVALID_HANDLE_VALUE &&
            DuplicateHandle(GetCurrentProcess(), own, GetCurrentProcess(), &copy, 0, TRUE,
                            DUPLICATE_SAME_ACCESS)) {
            CloseHandle(_handle);
            _handle = copy;
        }
    }
    ~InheritedHandle() {
        if (_handle != INVALID_HANDLE_VALUE)
            CloseHandle(_handle);
    }
    InheritedHandle(const InheritedHandle&) = delete;
    InheritedHandle& operator=(const InheritedHandle&) = delete;
    HANDLE get() const { return _handle; }

private:
    HANDLE _handle = INVALID_HANDLE_VALUE;
};

/// Starts a process that inherits the given handles only. @return its handle, or null.
HANDLE startProcess(const std::wstring& program, std::wstring line, HANDLE input, HANDLE output,
                    HANDLE error) {
    std::vector<HANDLE> handles = {input};
    for (const HANDLE each : {output, error})
        if (each != input)
            handles.push_back(each);
    SIZE_T size = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    std::vector<char> memory(size);
    const auto list = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(memory.data());
    InitializeProcThreadAttributeList(list, 1, 0, &size);
    UpdateProcThreadAttribute(list, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles.data(),
                              handles.size() * sizeof(HANDLE), nullptr, nullptr);
    STARTUPINFOEXW startup{};
    startup.StartupInfo.cb = sizeof startup;
    startup.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    startup.StartupInfo.hStdInput = input;
    startup.StartupInfo.hStdOutput = output;
    startup.StartupInfo.hStdError = error;
    startup.lpAttributeList = list;
    PROCESS_INFORMATION process{};
    const bool isStarted = CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE,
                                          EXTENDED_STARTUPINFO_PRESENT | CREATE_NO_WINDOW, nullptr, nullptr,
                                          &startup.StartupInfo, &process);
    const DWORD problem = GetLastError();
    DeleteProcThreadAttributeList(list);
    SetLastError(problem);
    if (!isStarted)
        return nullptr;
    CloseHandle(process.hThread);
    return process.hProcess;
}

} // namespace

std::string ChildProcess::startProgram(const std::string& program, const std::vector<std::string>& arguments,
                                       Connection connection) {
    const bool isTwoWay = connection == Connection::InputAndOutput;
    const std::wstring name = L"\\\\.\\pipe\\osgTreeWind-" + std::to_wstring(GetCurrentProcessId()) + L"-" +
                              std::to_wstring(std::random_device()());
    constexpr DWORD buffer = 1 << 16;
    const HANDLE ours = CreateNamedPipeW(
        name.c_str(), (isTwoWay ? PIPE_ACCESS_DUPLEX : PIPE_ACCESS_OUTBOUND) | FILE_FLAG_FIRST_PIPE_INSTANCE,
        PIPE_TYPE_BYTE | PIPE_READMODE_BYTE | PIPE_REJECT_REMOTE_CLIENTS, 1, buffer, buffer, 0, nullptr);
    if (ours == INVALID_HANDLE_VALUE)
        return messageOf(GetLastError());
    const InheritedHandle pipe(name.c_str(), isTwoWay ? GENERIC_READ | GENERIC_WRITE : GENERIC_READ),
        nothing(L"NUL", GENERIC_WRITE), output(STD_OUTPUT_HANDLE), error(STD_ERROR_HANDLE);
    const std::wstring path = toPath(program).make_preferred().native();
    std::wstring line = quoted(path);
    for (const std::string& argument : arguments)
        line += L' ' + quoted(toWide(argument));
    const HANDLE process =
        startProcess(path, std::move(line), pipe.get(), isTwoWay ? pipe.get() : output.get(),
                     isTwoWay ? nothing.get() : error.get());
    if (!process) {
        const std::string problem = messageOf(GetLastError());
        CloseHandle(ours);
        return problem;
    }
    _descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(ours), _O_BINARY | _O_RDWR);
    if (_descriptor < 0) { // too many files are open
        TerminateProcess(process, 1);
        CloseHandle(process);
        CloseHandle(ours);
        return std::generic_category().message(EMFILE);
    }
    _process = reinterpret_cast<std::intptr_t>(process);
    return {};
}

void ChildProcess::awaitEnd() {
    _close(_descriptor);
    _descriptor = -1;
    WaitForSingleObject(reinterpret_cast<HANDLE>(_process), INFINITE);
}

ChildProcess::End ChildProcess::takeEnd() {
    const auto process = reinterpret_cast<HANDLE>(_process);
    DWORD status = 0;
    GetExitCodeProcess(process, &status);
    _process = -1;
    CloseHandle(process);
    if (status == timeIsUpStatus)
        return {false, "timed out"};
    if (status == memoryIsUpStatus)
        return {false, "ran out of memory"};
    constexpr DWORD firstException = 0xc0000000;
    return {status == 0, status >= firstException ? "ended with: " + exceptionText(status)
                                                  : "ended with status " + std::to_string(status)};
}

void ChildProcess::kill() {
    if (_process == -1)
        return;
    const auto process = reinterpret_cast<HANDLE>(_process);
    TerminateProcess(process, 1);
    WaitForSingleObject(process, INFINITE);
}

} // namespace osgTreeWind
