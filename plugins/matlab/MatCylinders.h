// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/matlab/MatFile.h>

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/scanfiles/ScanMeasures.h>

#include <functional>

namespace osgTreeWind {

/// The arrays of the cylinders of one tree, which count from 1; the root's parent is 0.
class MatCylinders {
public:
    /// What TreeQSM calls them.
    struct Names {
        const char *radius, *length, *start, *axis, *parent;
    };
    /// The array of this name; null for none.
    using Arrays = std::function<matvar_t*(const char* name)>;

    /// @param path for diagnostics only.
    /// @param holder what holds the arrays, for diagnostics: "QSM(2).cylinder."
    MatCylinders(const Arrays& arrays, const Names& names, std::string path, std::string holder);

    /// The tree; the line of a cylinder is its number.
    Result<ScanCylinders> read();

private:
    /// An array as numbers, so many in each of its rows.
    struct Column {
        const char* name;
        std::size_t width;
        std::vector<double> values;
    };

    Column column(const Arrays& arrays, const char* name, std::size_t width);
    double number(const Column& column, std::size_t row, std::size_t i, const ScanMeasure& measure);
    glm::dvec3 vector(const Column& column, std::size_t row, const ScanMeasure& measure);
    ScanCylinder cylinder(std::size_t row);
    int parent(std::size_t row);
    void fail(const Column& column, std::size_t row, const std::string& message, std::size_t i = 0);

    const std::string _path, _holder;
    Diagnostic _problem; ///< The first.
    std::size_t _rows = 0;
    const Column _radius, _length, _start, _axis, _parent;
};

} // namespace osgTreeWind
