// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <netcdf.h>

#include <string>
#include <vector>

/// Content of a NetCDF file, read by the NetCDF library.
class NetCdf {
public:
    explicit NetCdf(const std::string& path) { check(nc_open(path.c_str(), NC_NOWRITE, &_file), path); }
    ~NetCdf() { nc_close(_file); }
    NetCdf(const NetCdf&) = delete;
    NetCdf& operator=(const NetCdf&) = delete;

    std::vector<std::string> dimensionsOf(const std::string& name) const {
        int count = 0, ids[NC_MAX_VAR_DIMS];
        const int array = idOf(name);
        check(nc_inq_varndims(_file, array, &count), name);
        check(nc_inq_vardimid(_file, array, ids), name);
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) {
            char dimension[NC_MAX_NAME + 1] = "";
            check(nc_inq_dimname(_file, ids[i], dimension), name);
            names.emplace_back(dimension);
        }
        return names;
    }
    std::vector<double> numbers(const std::string& name) const {
        std::vector<double> numbers(sizeOf(name));
        check(nc_get_var_double(_file, idOf(name), numbers.data()), name);
        return numbers;
    }
    std::vector<std::string> texts(const std::string& name) const {
        std::vector<char*> pointers(sizeOf(name));
        check(nc_get_var_string(_file, idOf(name), pointers.data()), name);
        std::vector<std::string> texts(pointers.begin(), pointers.end());
        nc_free_string(pointers.size(), pointers.data());
        return texts;
    }
    /// Text attribute. @param array empty for attributes of the file.
    std::string text(const std::string& array, const std::string& name) const {
        const int variable = array.empty() ? NC_GLOBAL : idOf(array);
        std::size_t length = 0;
        check(nc_inq_attlen(_file, variable, name.c_str(), &length), name);
        std::string text(length, ' ');
        check(nc_get_att_text(_file, variable, name.c_str(), text.data()), name);
        return text;
    }
    double number(const std::string& array, const std::string& name) const {
        double number = 0.0;
        check(nc_get_att_double(_file, array.empty() ? NC_GLOBAL : idOf(array), name.c_str(), &number), name);
        return number;
    }
    nc_type typeOf(const std::string& name) const {
        nc_type type = 0;
        check(nc_inq_vartype(_file, idOf(name), &type), name);
        return type;
    }

private:
    static void check(int status, const std::string& name) {
        EXPECT_EQ(status, NC_NOERR) << name << ": " << nc_strerror(status);
    }
    std::size_t sizeOf(const std::string& name) const {
        std::size_t size = 1;
        for (const std::string& dimension : dimensionsOf(name)) {
            int id = 0;
            std::size_t length = 0;
            check(nc_inq_dimid(_file, dimension.c_str(), &id), dimension);
            check(nc_inq_dimlen(_file, id, &length), dimension);
            size *= length;
        }
        return size;
    }
    int idOf(const std::string& name) const {
        int id = 0;
        check(nc_inq_varid(_file, name.c_str(), &id), name);
        return id;
    }
    int _file = 0;
};
