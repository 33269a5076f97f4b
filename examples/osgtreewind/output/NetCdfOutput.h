// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// A NetCDF file that is written: first what is in it, then its numbers. The first thing that goes wrong ends
/// it, and is its problem; what comes after is passed over.
class NetCdfOutput {
public:
    /// @param arrays the bytes of the largest array, which say what kind of NetCDF holds it.
    NetCdfOutput(const std::string& path, double largestArray);
    ~NetCdfOutput();
    NetCdfOutput(const NetCdfOutput&) = delete;
    NetCdfOutput& operator=(const NetCdfOutput&) = delete;

    static constexpr int wholeFile = -1; ///< In place of an array, for what is said of the file.

    int dimension(const char* name, int size);
    /// Of floats.
    int field(const char* name, const std::vector<int>& dimensions);
    /// Of doubles.
    int coordinates(const char* name, const std::vector<int>& dimensions);
    void say(int array, const char* name, const std::string& text);
    void say(int array, const char* name, const std::vector<double>& numbers);
    void say(int array, const char* name, float number);

    void endOfHead();
    void write(int array, const std::vector<double>& numbers);
    void write(int array, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
               const float* numbers);
    void close();

    /// Empty: all went well so far.
    const std::string& problem() const { return _problem; }

private:
    /// Whether there is no problem yet.
    bool goesOn() const { return _problem.empty(); }
    void keep(int status);
    int array(const char* name, int type, const std::vector<int>& dimensions);

    int _file = 0;
    bool _open = false;
    std::string _problem;
};
