// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <netcdf.h>

#include <string>
#include <vector>

/// A NetCDF file that is being written. After the first error all calls do nothing; problem() says what went
/// wrong. Define dimensions, variables and attributes before endDefinitions(), and write values after it.
class NetCdfFile {
public:
    static constexpr int global = NC_GLOBAL; ///< In place of a variable: the attributes of the file.

    /// @param format flags of nc_create(), such as NC_NETCDF4. Variables are not filled: write every value.
    NetCdfFile(const std::string& path, int format);
    ~NetCdfFile() { close(); }
    NetCdfFile(const NetCdfFile&) = delete;
    NetCdfFile& operator=(const NetCdfFile&) = delete;

    /// @param size NC_UNLIMITED grows with what is written.
    int defineDimension(const char* name, std::size_t size);
    int defineVariable(const char* name, int type, const std::vector<int>& dimensions);
    /// Compresses a variable of a NetCDF-4 file. @param chunk its size along each dimension.
    void compress(int variable, const std::vector<std::size_t>& chunk);
    /// Defines the variable `crs`, the grid mapping of a map projection.
    int defineMap(const osgTreeWind::Crs& map);
    void setAttribute(int variable, const char* name, const std::string& text);
    void setAttribute(int variable, const char* name, const std::vector<double>& numbers);
    void setAttribute(int variable, const char* name, float number);
    /// Sets long_name and units.
    void describe(int variable, const std::string& words, const std::string& units);
    /// Sets the attributes Conventions, title and source of the file.
    void describeFile(const std::string& title);
    void endDefinitions();

    void write(int variable, const std::vector<double>& numbers); ///< All values.
    void write(int variable, const std::vector<int>& numbers);
    void write(int variable, const std::vector<std::string>& texts);
    /// A part of a variable. @param start, count by dimension.
    void write(int variable, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
               const float* numbers);
    void write(int variable, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
               const double* numbers);

    bool close(); ///< @return whether all was written.
    const std::string& problem() const { return _problem; }

private:
    void check(int status);
    template <typename Function, typename... Arguments>
    void call(Function function, Arguments... arguments);

    int _file = 0;
    bool _open = false;
    std::string _problem;
};
