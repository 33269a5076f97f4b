// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/FolderLock.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Windows.h>

namespace osgTreeWind {

FolderLock::FolderLock(const std::string& folder) {
    // A file in the folder that nobody else may open. Windows removes it when its handle is closed, even
    // after a crash.
    const HANDLE file =
        CreateFileW((toPath(folder) / "writing.lock").c_str(), GENERIC_WRITE | DELETE, 0, nullptr,
                    OPEN_ALWAYS, FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    _isHeld = file != INVALID_HANDLE_VALUE;
    if (_isHeld)
        _handle = reinterpret_cast<std::intptr_t>(file);
    else if (const DWORD error = GetLastError();
             error != ERROR_SHARING_VIOLATION && error != ERROR_DELETE_PENDING)
        _problem = messageOf(error);
}

FolderLock::~FolderLock() {
    if (_isHeld)
        CloseHandle(reinterpret_cast<HANDLE>(_handle));
}

} // namespace osgTreeWind
