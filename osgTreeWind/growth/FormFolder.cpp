// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/FormFolder.h>

#include <osgTreeWind/base/TextHash.h>
#include <osgTreeWind/base/WholeFile.h>

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

constexpr char extension[] = ".form";
/// What a program that was ended left of a file that it wrote.
constexpr char unfinished[] = ".part";
constexpr std::chrono::hours longAgo{1};
constexpr std::uint64_t mostOfFile = std::uint64_t(1) << 28;

/// What a file begins with.
struct Head {
    char magic[8] = {'T', 'r', 'e', 'e', 'F', 'o', 'r', 'm'};
    std::uint32_t byteOrder = 0x01020304;
    std::uint32_t checksum = 0; ///< Of all that follows it.
    std::uint64_t keySize = 0, size = 0;
};

std::uint32_t checksumOf(std::string_view text) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

std::string contentOf(const std::string& key, const std::string& bytes) {
    std::string content = key + bytes;
    Head head;
    head.checksum = checksumOf(content);
    head.keySize = key.size();
    head.size = bytes.size();
    return std::string(reinterpret_cast<const char*>(&head), sizeof head) + content;
}

/// All of a file; empty where it is too large to be one of ours.
std::string readFile(const std::string& path) {
    std::error_code problem;
    const std::uint64_t size = files::file_size(path, problem);
    if (problem || size > mostOfFile)
        return {};
    std::string content(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(content.data(), static_cast<std::streamsize>(size));
    return file ? content : std::string();
}

} // namespace

std::string FormFolder::fileOf(const std::string& key) const {
    char name[17];
    std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hashOf(key)));
    return _path + '/' + name + extension;
}

std::optional<std::string> FormFolder::find(const std::string& key) const {
    if (_path.empty())
        return std::nullopt;
    const std::string path = fileOf(key), content = readFile(path);
    Head head;
    const Head ours;
    if (content.size() < sizeof head + key.size())
        return std::nullopt;
    std::memcpy(&head, content.data(), sizeof head);
    if (std::memcmp(head.magic, ours.magic, sizeof head.magic) != 0 || head.byteOrder != ours.byteOrder ||
        head.keySize != key.size() || head.size != content.size() - sizeof head - key.size() ||
        content.compare(sizeof head, key.size(), key) != 0 ||
        head.checksum != checksumOf(std::string_view(content).substr(sizeof head)))
        return std::nullopt;
    std::error_code ignored;
    files::last_write_time(path, files::file_time_type::clock::now(), ignored); // it is in use
    return content.substr(sizeof head + key.size());
}

void FormFolder::keep(const std::string& key, const std::string& bytes) const {
    std::error_code problem;
    if (_path.empty() || bytes.size() > _mostBytes)
        return;
    files::create_directories(_path, problem);
    if (!problem && writeWholeFile(fileOf(key), contentOf(key, bytes)).empty())
        trim();
}

void FormFolder::trim() const {
    struct File {
        files::file_time_type used;
        std::uint64_t size;
        files::path path;
    };
    std::vector<File> all;
    std::uint64_t sum = 0;
    std::error_code problem, ignored;
    for (files::directory_iterator i(_path, problem), end; !problem && i != end; i.increment(problem)) {
        File file{i->last_write_time(ignored), 0, i->path()};
        if (ignored)
            continue; // another program took it away
        if (file.path.extension() == unfinished && file.used < files::file_time_type::clock::now() - longAgo)
            files::remove(file.path, ignored);
        if (file.path.extension() != extension)
            continue;
        file.size = i->file_size(ignored);
        if (!ignored)
            sum += file.size;
        all.push_back(std::move(file));
    }
    if (sum <= _mostBytes)
        return;
    std::sort(all.begin(), all.end(), [](const File& a, const File& b) { return a.used < b.used; });
    for (const File& file : all) {
        if (sum <= _mostBytes)
            return;
        files::remove(file.path, ignored);
        sum -= file.size;
    }
}

} // namespace osgTreeWind
