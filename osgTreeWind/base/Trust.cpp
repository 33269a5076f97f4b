// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Trust.h>

#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

bool isInAnyFolder(const std::vector<std::string>& folders, const fs::path& path) {
    const fs::path file = resolved(path);
    return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        const fs::path root = resolved(folder.empty() ? "." : toPath(folder));
        return !file.empty() && !root.empty() &&
               std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
    });
}

/// Whether one of the folders is on the machine of a path that leavesTheMachine(), so that looking there
/// tells it nothing new.
bool isOnTrustedMachine(const std::vector<std::string>& folders, const std::string& path) {
    const auto machineOf = [](const std::string& name) {
        return foldedName(name.substr(2, name.find_first_of("/\\", 2) - 2));
    };
    return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        return leavesTheMachine(folder) && machineOf(folder) == machineOf(path);
    });
}

/// Libraries also open siblings with the same base name: parts of a shapefile, the world file of a raster.
bool hasSiblingOutside(const fs::path& file, const std::vector<std::string>& folders) {
    const std::string stem = foldedName(toText(file.stem()));
    std::error_code problem;
    for (const fs::directory_entry& each :
         fs::directory_iterator(file.has_parent_path() ? file.parent_path() : fs::path("."), problem))
        if (foldedName(toText(each.path().filename())).rfind(stem + '.', 0) == 0 &&
            !isInAnyFolder(folders, each.path()))
            return true;
    return false;
}

} // namespace

std::string problemOfNaming(const std::string& name, const std::vector<std::string>& folders) {
    const std::string problem = problemOfName(name);
    return problem.empty() && leavesTheMachine(name) ? problemOfTrust(name, folders) : problem;
}

std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders) {
    const std::string trust = environmentVariable("OSGTREEWIND_TRUST").value_or("");
    if (trust.empty())
        return {};
    if (trust != "folder")
        return "is not opened: expected OSGTREEWIND_TRUST to be \"folder\" or empty";
    if ((leavesTheMachine(path) && !isOnTrustedMachine(folders, path)) ||
        !isInAnyFolder(folders, toPath(path)))
        return "is not opened: it lies outside the folders that OSGTREEWIND_TRUST=folder trusts";
    return hasSiblingOutside(toPath(path), folders)
               ? "is not opened: a symbolic link next to it leads out of the folders that "
                 "OSGTREEWIND_TRUST=folder trusts"
               : "";
}

} // namespace osgTreeWind
