// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/File.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Windows.h>

#include <random>

namespace osgTreeWind {

namespace {

/// Opens a file or folder, without keeping others from doing anything. @return an error of GetLastError(), or
/// 0.
DWORD errorOfOpening(const std::string& path, DWORD access) {
    const HANDLE file =
        CreateFileW(toPath(path).c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                    nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        return GetLastError();
    CloseHandle(file);
    return 0;
}

/// Closes the files of this process with this path, or in this folder.
void closeFilesIn(const std::wstring& path) {
    constexpr std::uintptr_t step = 4, end = std::uintptr_t(1) << 16; // values of handles
    for (std::uintptr_t value = step; value < end; value += step) {
        const auto handle = reinterpret_cast<HANDLE>(value);
        if (GetFileType(handle) != FILE_TYPE_DISK)
            continue;
        const std::wstring name = pathOfFile(handle);
        if (name == path || name.rfind(path + L'\\', 0) == 0)
            CloseHandle(handle);
    }
}

} // namespace

FilePointer openFile(const std::string& path, const char* mode) {
    return FilePointer(_wfopen(toPath(path).c_str(), toWide(mode).c_str()));
}

FilePointer openVanishingFile(const std::string& folder) {
    std::random_device random; // GetTempFileName() knows no long paths
    const std::string name = "osgTreeWind-" + std::to_string(random()) + std::to_string(random());
    return openFile(folder + '/' + name, "w+bTD"); // an open file cannot be removed
}

bool seekFile(std::FILE* file, std::int64_t offset) {
    return _fseeki64(file, offset, SEEK_SET) == 0;
}

void removeUnfinished(const std::string& path) {
    std::error_code ignored;
    if (const std::filesystem::path own = resolved(toPath(path)); !own.empty())
        closeFilesIn(own.native());
    std::filesystem::remove_all(toPath(path), ignored);
}

bool mayWriteInto(const std::string& folder) {
    return errorOfOpening(folder, FILE_ADD_FILE) == 0;
}

bool isHeldOpen(const std::string& path) {
    return errorOfOpening(path, DELETE) == ERROR_SHARING_VIOLATION;
}

} // namespace osgTreeWind
