// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Program.h>

#include <osgTreeWind/system/Path.h>

#include <sstream>

namespace osgTreeWind {

std::vector<std::string> environmentFolders(const char* name) {
    std::istringstream rest(environmentVariable(name).value_or(""));
    std::vector<std::string> folders;
    for (std::string folder; std::getline(rest, folder, listSeparator);)
        if (!folder.empty())
            folders.push_back(folder);
    return folders;
}

std::string findProgram(const std::string& name) {
    for (const std::string& folder : environmentFolders("PATH")) {
        const std::filesystem::path path = toPath(folder) / toPath(name + programSuffix);
        std::error_code ignored;
        const std::filesystem::file_status file = std::filesystem::status(path, ignored);
        const bool isExecutable =
            (file.permissions() & std::filesystem::perms::owner_exec) != std::filesystem::perms::none;
        if (path.is_absolute() && std::filesystem::is_regular_file(file) && isExecutable)
            return toText(path);
    }
    return {};
}

} // namespace osgTreeWind
