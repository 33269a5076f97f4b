// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/AtomicFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/TextHash.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <random>
#include <set>

#include <sys/statvfs.h>
#include <unistd.h>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

constexpr char temporaryExtension[] = ".part";

/// A hash of the host name. Machines and containers that share a folder may have processes with equal ids.
const std::string& machine() {
    static const std::string hash = [] {
        char name[256] = {}, text[9];
        gethostname(name, sizeof name - 1);
        std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(hashOf(name)));
        return std::string(text);
    }();
    return hash;
}

std::string temporaryName(const std::string& path) {
    return path + '.' + machine() + '-' + std::to_string(getpid()) + '-' +
           std::to_string(std::random_device()()) + temporaryExtension;
}

/// Whether the name is that of a temporary file whose process ran on this machine and has ended.
bool isAbandoned(const std::string& name) {
    const std::string prefix = '.' + machine() + '-';
    const std::size_t at = name.rfind(prefix), digits = at + prefix.size();
    if (at == std::string::npos || fs::path(name).extension() != temporaryExtension)
        return false;
    const auto process = static_cast<pid_t>(std::strtol(name.c_str() + digits, nullptr, 10));
    return process > 0 && kill(process, 0) != 0 && errno == ESRCH;
}

/// Searches each folder only once per process.
void removeAbandonedFiles(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> searched;
    const std::lock_guard lock(mutex);
    if (!searched.insert(folder).second)
        return;
    std::error_code problem, ignored;
    for (fs::directory_iterator file(folder, problem), end; !problem && file != end; file.increment(problem))
        if (isAbandoned(file->path().filename().string()))
            fs::remove(file->path(), ignored);
}

fs::path folderOf(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder;
}

std::string targetOf(const std::string& path) {
    std::error_code problem;
    const fs::path target = fs::canonical(path, problem);
    return problem ? path : target.string();
}

bool isSpecialFile(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

} // namespace

AtomicFile::AtomicFile(const std::string& path)
    : _given(path), _path(targetOf(path)), _isSpecial(isSpecialFile(_path)),
      _temporary(temporaryName(_path)) {
    removeAbandonedFiles(folderOf(_path));
}

Diagnostic AtomicFile::problem(const std::string& fallback) const {
    constexpr std::uintmax_t minFreeBytes = 65536;
    const fs::path folder = folderOf(_path);
    std::error_code ignored;
    struct statvfs disk {};
    std::string reason = fallback;
    if (fs::is_directory(_path, ignored))
        reason = "it is a folder";
    else if (!_isSpecial && !fs::is_directory(folder, ignored))
        reason = "there is no folder " + folder.string();
    else if (!_isSpecial && access(folder.c_str(), W_OK) != 0)
        reason = "the folder cannot be written to";
    else if (!_isSpecial && statvfs(folder.c_str(), &disk) == 0 &&
             std::uintmax_t(disk.f_bavail) * disk.f_frsize < minFreeBytes)
        reason = "the disk is full";
    return fileProblem(_given, "cannot be written" + (reason.empty() ? "" : ": " + reason));
}

Diagnostics writeFileAtomically(const std::string& path, const std::string& bytes) {
    AtomicFile file(path);
    std::ofstream output(file.writePath(), std::ios::binary);
    output << bytes;
    output.close();
    if (!output || !file.commit())
        return {file.problem()};
    return {};
}

} // namespace osgTreeWind
