// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/matlab/MatFile.h>

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/scanfiles/ScanQuantity.h>

#include <functional>

namespace osgTreeWind {

/// Reads the cylinders of one tree from arrays. Parents are one-based; the root's parent is 0.
class MatCylinders {
public:
    /// Names of the arrays.
    struct Names {
        const char *radius, *length, *start, *axis, *parent;
    };
    /// Returns the array of a name; null if there is none.
    using FindArray = std::function<matvar_t*(const char* name)>;

    /// @param path for diagnostics only.
    /// @param prefix of the array names, for diagnostics, such as "QSM(2).cylinder."
    MatCylinders(const FindArray& findArray, const Names& names, std::string path, std::string prefix);

    /// Reads the tree. The line of a cylinder is its number.
    Result<ScanCylinders> read();

private:
    /// An array with `width` numbers in each row.
    struct Column {
        const char* name;
        std::size_t width;
        std::vector<double> values;
    };

    Column column(const FindArray& findArray, const char* name, std::size_t width);
    double number(const Column& column, std::size_t row, std::size_t i, const ScanQuantity& quantity);
    glm::dvec3 vector(const Column& column, std::size_t row, const ScanQuantity& quantity);
    ScanCylinder cylinder(std::size_t row);
    int parent(std::size_t row);
    void fail(const Column& column, std::size_t row, const std::string& message, std::size_t i = 0);

    const std::string _path, _prefix;
    Diagnostic _problem; ///< The first problem.
    std::size_t _rows = 0;
    const Column _radius, _length, _start, _axis, _parent;
};

} // namespace osgTreeWind
