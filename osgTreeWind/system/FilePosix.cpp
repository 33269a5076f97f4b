// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/File.h>

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace osgTreeWind {

FilePointer openFile(const std::string& path, const char* mode) {
    return FilePointer(std::fopen(path.c_str(), mode));
}

FilePointer openVanishingFile(const std::string& folder) {
    std::string path = folder + "/osgTreeWind-XXXXXX";
    const int file = mkstemp(path.data());
    if (file < 0)
        return nullptr;
    unlink(path.c_str());
    return FilePointer(fdopen(file, "w+b"));
}

bool seekFile(std::FILE* file, std::int64_t offset) {
    return fseeko(file, offset, SEEK_SET) == 0;
}

void removeUnfinished(const std::string& path) {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

bool mayWriteInto(const std::string& folder) {
    return access(folder.c_str(), W_OK) == 0;
}

bool isHeldOpen(const std::string&) {
    return false;
}

} // namespace osgTreeWind
