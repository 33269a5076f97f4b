// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/DiskCache.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/TextHash.h>
#include <osgTreeWind/system/Path.h>

#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace osgTreeWind {
namespace {

namespace files = std::filesystem;

constexpr char extension[] = ".cache";
/// Extension of a file that is being written; it stays if the program ends meanwhile.
constexpr char partExtension[] = ".part";
constexpr std::chrono::hours staleAge{1};
constexpr std::uint64_t maxFileSize = std::uint64_t(1) << 28;

/// Start of a file; the key and the value follow.
struct FileHeader {
    char magic[8] = {'T', 'r', 'e', 'e', 'W', 'i', 'n', 'd'};
    std::uint32_t byteOrder = 0x01020304;
    std::uint32_t checksum = 0; ///< Of the key and the value.
    std::uint64_t keySize = 0, size = 0;
};

std::uint32_t computeChecksum(std::string_view text) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

std::string fileContent(const std::string& key, const std::string& bytes) {
    std::string content = key + bytes;
    FileHeader head;
    head.checksum = computeChecksum(content);
    head.keySize = key.size();
    head.size = bytes.size();
    return std::string(reinterpret_cast<const char*>(&head), sizeof head) + content;
}

/// Whether no program has written to a file for a while.
bool isStale(const files::path& path) {
    std::error_code problem;
    const files::file_time_type written = files::last_write_time(path, problem);
    return !problem && written < files::file_time_type::clock::now() - staleAge;
}

/// Content of a file; empty if it cannot be read or is larger than any entry.
std::string readFile(const files::path& path) {
    std::error_code problem;
    const std::uint64_t size = files::file_size(path, problem);
    if (problem || size > maxFileSize)
        return {};
    std::string content(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(content.data(), static_cast<std::streamsize>(size));
    return file ? content : std::string();
}

} // namespace

std::string DiskCache::filePath(const std::string& key) const {
    char name[17];
    std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hashOf(key)));
    return _path + '/' + name + extension;
}

std::optional<std::string> DiskCache::find(const std::string& key) const {
    if (_path.empty())
        return std::nullopt;
    const files::path path = toPath(filePath(key));
    const std::string content = readFile(path);
    FileHeader head;
    const FileHeader ours;
    if (content.size() < sizeof head + key.size())
        return std::nullopt;
    std::memcpy(&head, content.data(), sizeof head);
    if (std::memcmp(head.magic, ours.magic, sizeof head.magic) != 0 || head.byteOrder != ours.byteOrder ||
        head.keySize != key.size() || head.size != content.size() - sizeof head - key.size() ||
        content.compare(sizeof head, key.size(), key) != 0 ||
        head.checksum != computeChecksum(std::string_view(content).substr(sizeof head)))
        return std::nullopt;
    std::error_code ignored;
    files::last_write_time(path, files::file_time_type::clock::now(), ignored); // the time of last use
    return content.substr(sizeof head + key.size());
}

void DiskCache::store(const std::string& key, const std::string& bytes) const {
    std::error_code problem;
    const std::string content = fileContent(key, bytes), path = filePath(key);
    if (_path.empty() || content.size() > _maxBytes)
        return;
    files::create_directories(toPath(_path), problem);
    if (!problem && writeFileAtomically(path, content).empty())
        evictOldestBut(path);
}

// The times of files may be whole seconds, so that the new file may seem as old as others.
void DiskCache::evictOldestBut(const std::string& kept) const {
    const files::path keptName = toPath(kept).filename();
    struct File {
        files::path path;
        std::uint64_t size;
        files::file_time_type used;
    };
    std::vector<File> all;
    std::uint64_t sum = 0;
    std::error_code problem, ignored; // another program may remove files meanwhile
    for (files::directory_iterator i(toPath(_path), problem), end; !problem && i != end;
         i.increment(problem)) {
        const files::path& path = i->path();
        if (path.extension() == partExtension && isStale(path))
            files::remove(path, ignored);
        if (path.extension() != extension)
            continue;
        const std::uint64_t size = files::file_size(path, ignored);
        if (ignored)
            continue;
        sum += size;
        if (path.filename() != keptName)
            all.push_back({path, size, {}});
    }
    if (sum <= _maxBytes)
        return;
    for (File& file : all)
        file.used = files::last_write_time(file.path, ignored);
    std::sort(all.begin(), all.end(), [](const File& a, const File& b) { return a.used < b.used; });
    for (const File& file : all) {
        if (sum <= _maxBytes)
            return;
        files::remove(file.path, ignored);
        if (!ignored)
            sum -= file.size;
    }
}

} // namespace osgTreeWind
