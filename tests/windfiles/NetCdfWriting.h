// SPDX-License-Identifier: MIT
#pragma once

#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/NetCdfReading.h>

#include <osgTreeWind/windfiles/WindFormats.h>

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace osgTreeWind {

using Numbers = std::vector<double>;
using NetCdfAttributes = std::vector<std::pair<std::string, std::variant<std::string, double>>>;

/// Writes a NetCDF file; the destructor closes it.
class NetCdfWriter {
public:
    explicit NetCdfWriter(const std::string& path, int mode = NC_64BIT_OFFSET) {
        check(nc_create(path.c_str(), mode | NC_CLOBBER, &_file));
    }
    NetCdfWriter(const NetCdfWriter&) = delete;
    NetCdfWriter& operator=(const NetCdfWriter&) = delete;
    ~NetCdfWriter() { check(nc_close(_file)); }

    NetCdfWriter& dimension(const std::string& name, std::size_t size) {
        int ignored = 0;
        check(nc_def_dim(_file, name.c_str(), size, &ignored));
        return *this;
    }

    /// Adds an array over existing dimensions; if there are too few numbers, the rest is not written.
    NetCdfWriter& array(const std::string& name, const std::vector<std::string>& dimensions,
                        const NetCdfAttributes& attributes, const Numbers& numbers,
                        nc_type type = NC_DOUBLE) {
        std::vector<int> ids;
        for (const std::string& dimension : dimensions) {
            ids.push_back(0);
            check(nc_inq_dimid(_file, dimension.c_str(), &ids.back()));
        }
        int id = 0;
        check(nc_def_var(_file, name.c_str(), type, static_cast<int>(ids.size()), ids.data(), &id));
        for (const auto& [attribute, value] : attributes)
            put(id, attribute, value, type);
        check(nc_enddef(_file));
        if (!numbers.empty())
            check(nc_put_var_double(_file, id, numbers.data()));
        check(nc_redef(_file));
        return *this;
    }

    /// Adds a dimension and its coordinates.
    NetCdfWriter& axis(const std::string& name, const Numbers& at, const std::string& unit,
                       const NetCdfAttributes& more = {}, nc_type type = NC_DOUBLE) {
        NetCdfAttributes attributes = more;
        if (!unit.empty())
            attributes.emplace_back("units", unit);
        return dimension(name, at.size()).array(name, {name}, attributes, at, type);
    }

    NetCdfWriter& attribute(const std::string& name, const std::variant<std::string, double>& value) {
        put(NC_GLOBAL, name, value, NC_DOUBLE);
        return *this;
    }

private:
    static void check(int status) { EXPECT_EQ(status, NC_NOERR) << nc_strerror(status); }

    void put(int array, const std::string& name, const std::variant<std::string, double>& value,
             nc_type type) {
        const bool isMark = (name == "_FillValue" || name == "missing_value") && array != NC_GLOBAL;
        if (const auto* text = std::get_if<std::string>(&value))
            check(nc_put_att_text(_file, array, name.c_str(), text->size(), text->c_str()));
        else
            check(nc_put_att_double(_file, array, name.c_str(), isMark ? type : NC_DOUBLE, 1,
                                    &std::get<double>(value)));
    }

    int _file = 0;
};

/// `count` numbers from `first` on.
inline Numbers numbersFrom(double first, double step, std::size_t count) {
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(first + step * static_cast<double>(i));
    return numbers;
}

/// Values of a function at all rows and columns, columns fastest.
inline Numbers valuesOver(const Numbers& y, const Numbers& x,
                          const std::function<double(double y, double x)>& f) {
    Numbers numbers;
    for (const double row : y)
        for (const double column : x)
            numbers.push_back(f(row, column));
    return numbers;
}

/// The same at all levels, rows and columns.
inline Numbers valuesOver(const Numbers& z, const Numbers& y, const Numbers& x,
                          const std::function<double(double z, double y, double x)>& f) {
    Numbers numbers;
    for (const double level : z)
        for (const double number :
             valuesOver(y, x, [&](double row, double column) { return f(level, row, column); }))
            numbers.push_back(number);
    return numbers;
}

/// Packed as 16-bit integers.
inline Numbers packed(Numbers numbers, double scale, double offset) {
    for (double& number : numbers)
        number = std::round((number - offset) / scale);
    return numbers;
}

inline const NetCdfAttributes metresPerSecond = {{"units", "m s**-1"}};

/// Content from the reader as stored, without conversion to the scene.
inline Result<WindContent> contentOf(const std::string& path, const std::optional<WindArea>& area = {}) {
    WindRequest request;
    request.area = area;
    return readNetCdf(path, request);
}

/// The grid of a file that must be readable.
inline GridWind::Grid gridOf(const std::string& path, const std::optional<WindArea>& area = {}) {
    const Result<WindContent> content = contentOf(path, area);
    EXPECT_TRUE(content) << firstProblem(content);
    return content ? std::get<GridWind::Grid>(content.value().data) : GridWind::Grid{};
}

inline WindSummary summaryOf(const std::string& path) {
    const Result<WindContent> content = contentOf(path);
    EXPECT_TRUE(content) << firstProblem(content);
    return content ? content.value().summary : WindSummary{};
}

/// The velocity of a point of a grid.
inline glm::vec3 velocityAt(const GridWind::Grid& grid, int t, int z, int y, int x) {
    const int at = 3 * (((t * grid.points.z + z) * grid.points.y + y) * grid.points.x + x);
    EXPECT_GE(at, 0);
    if (at < 0 || static_cast<std::size_t>(at) + 2 >= grid.values.size()) {
        ADD_FAILURE() << "no point " << t << ", " << z << ", " << y << ", " << x;
        return glm::vec3(-999.0f);
    }
    const float* values = grid.values.data() + at;
    return {values[0], values[1], values[2]};
}

} // namespace osgTreeWind
