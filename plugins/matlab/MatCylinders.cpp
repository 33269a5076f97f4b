// SPDX-License-Identifier: MIT
#include <plugins/matlab/MatCylinders.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/scanfiles/ScanFile.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>

namespace osgTreeWind {

MatCylinders::MatCylinders(const FindArray& findArray, const Names& names, std::string path,
                           std::string prefix)
    : _path(std::move(path)), _prefix(std::move(prefix)), _radius(column(findArray, names.radius, 1)),
      _length(column(findArray, names.length, 1)), _start(column(findArray, names.start, 3)),
      _axis(column(findArray, names.axis, 3)), _parent(column(findArray, names.parent, 1)) {}

Result<ScanCylinders> MatCylinders::read() {
    ScanCylinders tree;
    std::vector<ScanLink> links;
    for (std::size_t row = 0; row < _rows && _problem.message.empty(); ++row) {
        tree.push_back(cylinder(row));
        links.push_back({tree.back().line, parent(row), tree.back().line});
    }
    makeOneBased(links);
    if (_problem.message.empty())
        if (const auto unlinked = setParents(tree, links, 0, _path))
            fail(_parent, static_cast<std::size_t>(unlinked->line) - 1, unlinked->message);
    if (!_problem.message.empty())
        return _problem;
    return tree;
}

MatCylinders::Column MatCylinders::column(const FindArray& findArray, const char* name, std::size_t width) {
    const matvar_t* array = _problem.message.empty() ? findArray(name) : nullptr;
    std::vector<double> values = array ? numbers(*array) : std::vector<double>();
    if (_rows == 0) // the first column determines the number of rows
        _rows = values.size();
    const bool isColumn = array && array->rank == 2 && (width == 1 || array->dims[0] == _rows);
    if (_problem.message.empty() && (!isColumn || _rows == 0 || values.size() != width * _rows))
        _problem = {_path, 0, 0, _prefix + name,
                    "expected " + std::string(width == 3 ? "3 real numbers" : "a real number") +
                        (_rows > 0 ? " for each of " + std::to_string(_rows) + " cylinders"
                                   : std::string(" for each cylinder"))};
    if (_problem.message.empty() && _rows > maxScanCylinders)
        _problem = {_path, 0, 0, _prefix + name,
                    "expected at most " + std::to_string(maxScanCylinders) + " cylinders"};
    return {name, width, std::move(values)};
}

double MatCylinders::number(const Column& column, std::size_t row, std::size_t i,
                            const ScanQuantity& quantity) {
    const double value = column.values[row + i * _rows];
    if (!quantity.range.contains(value))
        fail(column, row, expectedFound(quantity.description, numberText(value)), i);
    return value;
}

glm::dvec3 MatCylinders::vector(const Column& column, std::size_t row, const ScanQuantity& quantity) {
    return {number(column, row, 0, quantity), number(column, row, 1, quantity),
            number(column, row, 2, quantity)};
}

ScanCylinder MatCylinders::cylinder(std::size_t row) {
    ScanCylinder cylinder;
    cylinder.radius = number(_radius, row, 0, scanRadius);
    const double length = number(_length, row, 0, scanLength);
    cylinder.start = vector(_start, row, scanMetres);
    const glm::dvec3 axis = vector(_axis, row, scanDirection);
    if (const std::string wrong = setEndFromAxis(axis, length, cylinder); !wrong.empty())
        fail(_axis, row, wrong);
    cylinder.line = static_cast<int>(row) + 1;
    return cylinder;
}

int MatCylinders::parent(std::size_t row) {
    const ScanQuantity quantity{"the number of the parent cylinder, or 0", within(-1.0, maxScanCylinders)};
    const double parent = number(_parent, row, 0, quantity);
    if (!_problem.message.empty())
        return 0;
    if (parent != static_cast<int>(parent))
        fail(_parent, row, expectedFound(quantity.description, numberText(parent)));
    return static_cast<int>(parent);
}

void MatCylinders::fail(const Column& column, std::size_t row, const std::string& message, std::size_t i) {
    if (!_problem.message.empty())
        return;
    const std::string place = std::to_string(row + 1) + (column.width > 1 ? ',' + std::to_string(i + 1) : "");
    _problem = {_path, 0, 0, _prefix + column.name + '(' + place + ')', message};
}

} // namespace osgTreeWind
