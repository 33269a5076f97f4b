// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/AtomicFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/TextHash.h>
#include <osgTreeWind/system/File.h>
#include <osgTreeWind/system/Machine.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <random>
#include <set>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

constexpr char temporaryExtension[] = ".part";

/// A hash of the host and its system. Machines, containers and a Linux within Windows that share a folder may
/// have processes with equal ids.
const std::string& machine() {
    static const std::string hash = [] {
        char text[9];
        std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(hashOf(hostName() + programSuffix)));
        return std::string(text);
    }();
    return hash;
}

std::string temporaryName(const std::string& path) {
    return path + '.' + machine() + '-' + std::to_string(processId()) + '-' +
           std::to_string(std::random_device()()) + temporaryExtension;
}

/// Whether the name is that of a temporary file whose process ran on this machine and has ended.
bool isAbandoned(const std::string& name) {
    const std::string prefix = '.' + machine() + '-';
    const std::size_t at = name.rfind(prefix), digits = at + prefix.size();
    if (at == std::string::npos || extensionOf(name) != temporaryExtension)
        return false;
    const long process = std::strtol(name.c_str() + digits, nullptr, 10);
    return process > 0 && hasEnded(process);
}

/// Searches each folder only once per process.
void removeAbandonedFiles(const std::string& folder) {
    static std::mutex mutex;
    static std::set<std::string> searched;
    const std::lock_guard lock(mutex);
    if (!searched.insert(folder).second)
        return;
    std::error_code problem, ignored;
    for (fs::directory_iterator file(toPath(folder), problem), end; !problem && file != end;
         file.increment(problem))
        if (isAbandoned(toText(file->path().filename())))
            fs::remove(file->path(), ignored);
}

std::string nonEmptyFolderOf(const std::string& path) {
    const std::string folder = folderOf(path);
    return folder.empty() ? "." : folder;
}

std::string targetOf(const std::string& path) {
    const fs::path target = isLink(path) ? resolved(toPath(path)) : fs::path();
    return target.empty() ? path : toText(target);
}

bool isSpecialFile(const std::string& path) {
    std::error_code ignored;
    const fs::file_status file = fs::status(toPath(path), ignored);
    return fs::exists(file) && !fs::is_regular_file(file);
}

} // namespace

AtomicFile::AtomicFile(const std::string& path)
    : _given(path), _path(targetOf(path)), _isSpecial(isSpecialFile(_path)),
      _temporary(temporaryName(_path)) {
    removeAbandonedFiles(nonEmptyFolderOf(_path));
}

Diagnostic AtomicFile::problem(const std::string& fallback) const {
    constexpr std::uintmax_t minFreeBytes = 65536;
    const std::string folder = nonEmptyFolderOf(_path);
    std::error_code ignored, unknown;
    const fs::space_info disk = fs::space(toPath(folder), unknown);
    std::string reason = fallback;
    if (fs::is_directory(toPath(_path), ignored))
        reason = "it is a folder";
    else if (!_isSpecial && !fs::is_directory(toPath(folder), ignored))
        reason = "there is no folder " + folder;
    else if (!_isSpecial && !mayWriteInto(folder))
        reason = "the folder cannot be written to";
    else if (!_isSpecial && !unknown && disk.available < minFreeBytes)
        reason = "the disk is full";
    else if (!_isSpecial && isHeldOpen(_path))
        reason = "another program holds it open";
    return fileProblem(_given, "cannot be written" + (reason.empty() ? "" : ": " + reason));
}

Diagnostics writeFileAtomically(const std::string& path, const std::string& bytes) {
    AtomicFile file(path);
    std::ofstream output(toPath(file.writePath()), std::ios::binary);
    output << bytes;
    output.close();
    if (!output || !file.commit())
        return {file.problem()};
    return {};
}

} // namespace osgTreeWind
