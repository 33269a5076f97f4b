// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Path.h>

namespace osgTreeWind {

std::string folderOf(const std::string& path) {
    return toText(toPath(path).parent_path());
}

std::string extensionOf(const std::string& path) {
    return toText(toPath(path).extension());
}

std::string stemOf(const std::string& path) {
    return toText(toPath(path).stem());
}

std::string absolutePath(const std::string& path) {
    return toText(std::filesystem::absolute(toPath(path)));
}

std::string pathIn(const std::string& folder, const std::string& path) {
    return toText((toPath(folder) / toPath(path)).lexically_normal());
}

} // namespace osgTreeWind
