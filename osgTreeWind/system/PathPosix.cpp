// SPDX-License-Identifier: MIT
#include <osgTreeWind/system/Path.h>

namespace osgTreeWind {

std::filesystem::path toPath(const std::string& text) {
    return text;
}

std::string toText(const std::filesystem::path& path) {
    return path.string();
}

std::filesystem::path resolved(const std::filesystem::path& path) {
    std::error_code problem;
    std::filesystem::path result = std::filesystem::canonical(path, problem);
    return problem ? std::filesystem::path() : result;
}

bool isLink(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_symlink(path, ignored);
}

std::string problemOfName(const std::string&) {
    return {};
}

bool leavesTheMachine(const std::string&) {
    return false;
}

} // namespace osgTreeWind
