// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/WholeFile.h>

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

constexpr char ending[] = ".part";

/// Tells processes of two machines or containers apart that have one number.
const std::string& machine() {
    static const std::string known = [] {
        char name[256] = {}, text[9];
        gethostname(name, sizeof name - 1);
        std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(hashOf(name)));
        return std::string(text);
    }();
    return known;
}

std::string unfinishedName(const std::string& path) {
    return path + '.' + machine() + '-' + std::to_string(getpid()) + '-' +
           std::to_string(std::random_device()()) + ending;
}

/// Whether it is the unfinished file of a process of this machine that is no more.
bool isAbandoned(const std::string& name) {
    const std::string ours = '.' + machine() + '-';
    const std::size_t at = name.rfind(ours), digits = at + ours.size();
    if (at == std::string::npos || fs::path(name).extension() != ending)
        return false;
    const auto process = static_cast<pid_t>(std::strtol(name.c_str() + digits, nullptr, 10));
    return process > 0 && kill(process, 0) != 0 && errno == ESRCH;
}

/// Once for each folder.
void removeAbandoned(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> looked;
    const std::lock_guard lock(mutex);
    if (!looked.insert(folder).second)
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

bool isSomethingElse(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

} // namespace

WholeFile::WholeFile(const std::string& path)
    : _given(path), _path(targetOf(path)), _isTaken(isSomethingElse(_path)),
      _unfinished(unfinishedName(_path)) {
    removeAbandoned(folderOf(_path));
}

Diagnostic WholeFile::problem(const std::string& otherwise) const {
    constexpr std::uintmax_t least = 65536; // bytes
    const fs::path folder = folderOf(_path);
    std::error_code ignored;
    struct statvfs disk {};
    std::string reason = otherwise;
    if (fs::is_directory(_path, ignored))
        reason = "it is a folder";
    else if (!_isTaken && !fs::is_directory(folder, ignored))
        reason = "there is no folder " + folder.string();
    else if (!_isTaken && access(folder.c_str(), W_OK) != 0)
        reason = "the folder cannot be written to";
    else if (!_isTaken && statvfs(folder.c_str(), &disk) == 0 &&
             std::uintmax_t(disk.f_bavail) * disk.f_frsize < least)
        reason = "the disk is full";
    return fileProblem(_given, "cannot be written" + (reason.empty() ? "" : ": " + reason));
}

Diagnostics writeWholeFile(const std::string& path, const std::string& bytes) {
    WholeFile file(path);
    std::ofstream output(file.unfinished(), std::ios::binary);
    output << bytes;
    output.close();
    if (!output || !file.putInPlace())
        return {file.problem()};
    return {};
}

} // namespace osgTreeWind
