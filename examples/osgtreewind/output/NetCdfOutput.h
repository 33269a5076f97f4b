// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// A NetCDF file that is written: first its definitions, then its numbers. The first error is kept in
/// problem(), and later calls do nothing.
class NetCdfOutput {
public:
    /// @param largestArray its size in bytes, which decides the file format.
    NetCdfOutput(const std::string& path, double largestArray);
    ~NetCdfOutput();
    NetCdfOutput(const NetCdfOutput&) = delete;
    NetCdfOutput& operator=(const NetCdfOutput&) = delete;

    static constexpr int wholeFile = -1; ///< In place of an array, for what is said of the file.

    int dimension(const char* name, int size);
    /// Defines an array of floats.
    int field(const char* name, const std::vector<int>& dimensions);
    /// Defines an array of doubles.
    int coordinates(const char* name, const std::vector<int>& dimensions);
    void attribute(int array, const char* name, const std::string& text);
    void attribute(int array, const char* name, const std::vector<double>& numbers);
    void attribute(int array, const char* name, float number);

    void endDefinitions();
    void write(int array, const std::vector<double>& numbers);
    void write(int array, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
               const float* numbers);
    void close();

    /// Empty: all went well so far.
    const std::string& problem() const { return _problem; }

private:
    /// Whether there is no problem yet.
    bool ok() const { return _problem.empty(); }
    void keep(int status);
    int array(const char* name, int type, const std::vector<int>& dimensions);

    int _file = 0;
    bool _open = false;
    std::string _problem;
};
