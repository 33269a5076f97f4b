// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Windows.h>

#include <algorithm>
#include <cwctype>

namespace osgTreeWind {

namespace {

/// Whether a name is that of a device, with any extension and with blanks at its end.
bool isDevice(std::wstring name) {
    name = name.substr(0, name.find(L'.'));
    name.erase(name.find_last_not_of(L' ') + 1);
    std::transform(name.begin(), name.end(), name.begin(), std::towupper);
    for (const wchar_t* device : {L"CON", L"PRN", L"AUX", L"NUL", L"CONIN$", L"CONOUT$"})
        if (name == device)
            return true;
    const bool isPort = name.size() == 4 && (name.rfind(L"COM", 0) == 0 || name.rfind(L"LPT", 0) == 0);
    return isPort &&
           std::wstring_view(L"0123456789\u00b9\u00b2\u00b3").find(name[3]) != std::wstring_view::npos;
}

} // namespace

std::wstring toWide(std::string_view text) {
    const auto size = static_cast<int>(text.size());
    std::wstring wide(
        static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), static_cast<int>(wide.size()));
    return wide;
}

std::string toUtf8(std::wstring_view wide) {
    const auto size = static_cast<int>(wide.size());
    const int bytes = WideCharToMultiByte(CP_UTF8, 0, wide.data(), size, nullptr, 0, nullptr, nullptr);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    WideCharToMultiByte(CP_UTF8, 0, wide.data(), size, text.data(), bytes, nullptr, nullptr);
    return text;
}

std::string messageOf(unsigned long error) {
    // The texts of POSIX where it knows the error, as on other systems; Windows' own are in the user's
    // language.
    const std::error_condition generic =
        std::system_category().default_error_condition(static_cast<int>(error));
    return generic.message();
}

std::filesystem::path toPath(const std::string& text) {
    return toWide(text);
}

std::string toText(const std::filesystem::path& path) {
    std::string text = toUtf8(path.native());
    std::replace(text.begin(), text.end(), '\\', '/');
    return text;
}

std::wstring pathOfFile(HANDLE file) {
    std::wstring name(32768, L'\0'); // the longest path
    name.resize(GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), 0));
    constexpr std::wstring_view verbatim = L"\\\\?\\", server = L"\\\\?\\UNC\\";
    if (name.rfind(server, 0) == 0)
        return L"\\\\" + name.substr(server.size());
    return name.rfind(verbatim, 0) == 0 ? name.substr(verbatim.size()) : name;
}

std::filesystem::path resolved(const std::filesystem::path& path) {
    const HANDLE file = CreateFileW(path.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        return {};
    const std::wstring name = pathOfFile(file);
    CloseHandle(file);
    return name;
}

bool isLink(const std::string& path) {
    const DWORD attributes = GetFileAttributesW(toPath(path).c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
}

std::string problemOfName(const std::string& text) {
    std::wstring name = toWide(text);
    std::replace(name.begin(), name.end(), L'/', L'\\');
    const bool hasDrive = name.size() > 1 && name[1] == L':' && std::iswalpha(name[0]);
    if (hasDrive && (name.size() < 3 || name[2] != L'\\'))
        return "depends on the current folder of a drive; expected a path such as C:/folder/file";
    const auto begins = [&](const wchar_t* text) { return name.rfind(text, 0) == 0; };
    if (begins(L"\\\\.\\") || begins(L"\\??\\"))
        return "names a device; expected a file";
    const std::size_t drive = begins(L"\\\\?\\") ? 4 : 0, colon = name.find(L':', drive);
    if (colon != std::wstring::npos &&
        (colon != drive + 1 || name.find(L':', colon + 1) != std::wstring::npos))
        return "names a stream of a file; expected a file";
    for (std::size_t begin = 0; begin < name.size();) { // a device in any folder is the device
        const std::size_t end = std::min(name.find(L'\\', begin), name.size());
        if (isDevice(name.substr(begin, end - begin)))
            return "names a device; expected a file";
        begin = end + 1;
    }
    return {};
}

bool leavesTheMachine(const std::string& text) {
    const auto isSlash = [](char c) { return c == '/' || c == '\\'; };
    return text.size() > 1 && isSlash(text[0]) && (isSlash(text[1]) || text[1] == '?');
}

} // namespace osgTreeWind
