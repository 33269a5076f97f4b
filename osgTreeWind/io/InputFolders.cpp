// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InputFolders.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <filesystem>

namespace osgTreeWind {

std::vector<std::string> hostFolders() {
    return environmentFolders("OSG_FILE_PATH");
}

std::string InputFolders::problemOfName(const std::string& name) const {
    return problemOfNaming(name, trusted());
}

std::string InputFolders::problemOfTrust(const std::string& path) const {
    return osgTreeWind::problemOfTrust(path, trusted());
}

std::vector<std::string> InputFolders::trusted() const {
    std::vector<std::string> folders = hostFolders();
    folders.push_back(ofDocument());
    if (const auto data = environmentVariable("OSGTREEWIND_DATA"))
        folders.push_back(*data);
    return folders;
}

std::optional<InputFolders::File> InputFolders::open(TableReader& table, const std::string& key) const {
    std::string name;
    if (!table.require(key, name))
        return std::nullopt;
    return open(table, key, name);
}

std::optional<InputFolders::File> InputFolders::open(TableReader& table, const std::string& key,
                                                     const std::string& name) const {
    const auto refuse = [&](const std::string& file, const std::string& problem) -> std::optional<File> {
        table.problem(key, inQuotes(file) + ' ' + problem);
        return std::nullopt;
    };
    if (const std::string problem = problemOfName(name); !problem.empty())
        return refuse(name, problem);
    std::error_code error;
    for (const std::string& folder : _folders) {
        const std::filesystem::path file = toPath(folder) / toPath(name); // `name` may be absolute
        if (!std::filesystem::is_regular_file(file, error))
            continue;
        const std::string path = toText(file);
        if (const std::string problem = problemOfTrust(path); !problem.empty())
            return refuse(name, problem);
        Result<std::ifstream> stream = openInput(path);
        if (!stream)
            return refuse(path, stream.problems().front().message);
        return File{path, std::move(stream.value())};
    }
    table.problem(key, "no file " + inQuotes(name) + " in " + joined(_folders));
    return std::nullopt;
}

} // namespace osgTreeWind
