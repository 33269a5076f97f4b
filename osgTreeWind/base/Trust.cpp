// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Trust.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

bool isInFolder(const fs::path& file, const std::string& folder) {
    std::error_code problem;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, problem);
    return !problem && std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

bool isInAnyFolder(const std::vector<std::string>& folders, const fs::path& path) {
    std::error_code problem;
    const fs::path file = fs::canonical(path, problem);
    return !problem && std::any_of(folders.begin(), folders.end(),
                                   [&](const std::string& folder) { return isInFolder(file, folder); });
}

/// Libraries also open siblings with the same base name: parts of a shapefile, the world file of a raster.
bool hasSiblingLinkOutside(const fs::path& file, const std::vector<std::string>& folders) {
    const std::string prefix = file.stem().string() + '.';
    std::error_code problem;
    for (const fs::directory_entry& each :
         fs::directory_iterator(file.has_parent_path() ? file.parent_path() : fs::path("."), problem))
        if (each.path().filename().string().rfind(prefix, 0) == 0 && each.is_symlink(problem) &&
            !isInAnyFolder(folders, each.path()))
            return true;
    return false;
}

} // namespace

std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders) {
    const char* const trust = std::getenv("OSGTREEWIND_TRUST");
    if (!trust || !*trust)
        return {};
    if (trust != std::string("folder"))
        return "is not opened: expected OSGTREEWIND_TRUST to be \"folder\" or empty";
    if (!isInAnyFolder(folders, path))
        return "is not opened: it lies outside the folders that OSGTREEWIND_TRUST=folder trusts";
    return hasSiblingLinkOutside(path, folders)
               ? "is not opened: a symbolic link next to it leads out of the folders that "
                 "OSGTREEWIND_TRUST=folder trusts"
               : "";
}

} // namespace osgTreeWind
