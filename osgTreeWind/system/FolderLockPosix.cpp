// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/FolderLock.h>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace osgTreeWind {

FolderLock::FolderLock(const std::string& folder)
    : _handle(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (_handle < 0)
        _problem = std::generic_category().message(errno);
    else
        _isHeld = flock(static_cast<int>(_handle), LOCK_EX | LOCK_NB) == 0;
}

FolderLock::~FolderLock() {
    if (_handle >= 0)
        close(static_cast<int>(_handle));
}

} // namespace osgTreeWind
