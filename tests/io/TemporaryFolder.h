// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

/// Creates a temporary folder and removes it on destruction.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::random_device random;
        do {
            _path = (std::filesystem::temp_directory_path() / ("osgTreeWind-" + std::to_string(random())))
                        .generic_string();
        } while (std::filesystem::exists(_path));
        std::filesystem::create_directory(_path);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return _path; }

    std::size_t countFiles() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(_path), {}));
    }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& content) const {
        const std::string file = _path + '/' + name;
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }

private:
    std::string _path;
};
