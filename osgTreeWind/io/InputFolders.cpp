// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InputFolders.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Trust.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace osgTreeWind {

std::vector<std::string> hostFolders() {
#ifdef _WIN32
    constexpr char separator = ';';
#else
    constexpr char separator = ':';
#endif
    const char* const text = std::getenv("OSG_FILE_PATH");
    std::istringstream rest(text ? text : "");
    std::vector<std::string> folders;
    for (std::string folder; std::getline(rest, folder, separator);)
        if (!folder.empty())
            folders.push_back(folder);
    return folders;
}

std::string InputFolders::problemOfTrust(const std::string& path) const {
    std::vector<std::string> trusted = hostFolders();
    trusted.push_back(ofDocument());
    if (const char* data = std::getenv("OSGTREEWIND_DATA"))
        trusted.emplace_back(data);
    return osgTreeWind::problemOfTrust(path, trusted);
}

std::optional<InputFolders::File> InputFolders::open(TableReader& table, const std::string& key) const {
    std::string name;
    if (!table.require(key, name))
        return std::nullopt;
    return open(table, key, name);
}

std::optional<InputFolders::File> InputFolders::open(TableReader& table, const std::string& key,
                                                     const std::string& name) const {
    std::error_code error;
    for (const std::string& folder : _folders) {
        const std::filesystem::path path = std::filesystem::path(folder) / name; // `name` may be absolute
        if (!std::filesystem::is_regular_file(path, error))
            continue;
        if (const std::string problem = problemOfTrust(path.string()); !problem.empty()) {
            table.problem(key, inQuotes(name) + ' ' + problem);
            return std::nullopt;
        }
        Result<std::ifstream> stream = openInput(path.string());
        if (stream)
            return File{path.string(), std::move(stream.value())};
        table.problem(key, inQuotes(path.string()) + " " + stream.problems().front().message);
        return std::nullopt;
    }
    table.problem(key, "no file " + inQuotes(name) + " in " + joined(_folders));
    return std::nullopt;
}

} // namespace osgTreeWind
