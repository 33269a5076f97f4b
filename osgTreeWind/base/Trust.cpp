// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Trust.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

bool liesIn(const fs::path& file, const std::string& folder) {
    std::error_code problem;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, problem);
    return !problem && std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

} // namespace

std::string problemOfTrust(const std::string& path, const std::vector<std::string>& folders) {
    const char* const trust = std::getenv("OSGTREEWIND_TRUST");
    if (!trust || !*trust)
        return {};
    if (trust != std::string("folder"))
        return "is not opened: expected OSGTREEWIND_TRUST to be \"folder\" or empty";
    std::error_code problem;
    const fs::path file = fs::canonical(path, problem);
    const bool isIn = std::any_of(folders.begin(), folders.end(),
                                  [&](const std::string& folder) { return liesIn(file, folder); });
    return !problem && isIn
               ? ""
               : "is not opened: it lies outside the folders that OSGTREEWIND_TRUST=folder trusts";
}

std::vector<std::string> foldersOf(const char* variable) {
#ifdef _WIN32
    constexpr char separator = ';';
#else
    constexpr char separator = ':';
#endif
    const char* const text = std::getenv(variable);
    std::istringstream rest(text ? text : "");
    std::vector<std::string> folders;
    for (std::string folder; std::getline(rest, folder, separator);)
        if (!folder.empty())
            folders.push_back(folder);
    return folders;
}

} // namespace osgTreeWind
