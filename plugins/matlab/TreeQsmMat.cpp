// SPDX-License-Identifier: MIT
#include <plugins/matlab/TreeQsmMat.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanMeasures.h>

#include <algorithm>
#include <functional>

namespace osgTreeWind {

namespace {

/// What TreeQSM calls its arrays.
struct ArrayNames {
    const char *radius, *length, *start, *axis, *parent;
};

constexpr ArrayNames names{"radius", "length", "start", "axis", "parent"},
    oldNames{"Rad", "Len", "Sta", "Axe", "CPar"};

/// The array of a name; null for none.
using Arrays = std::function<matvar_t*(const char* name)>;

/// The arrays of the cylinders of one tree, which count from 1; the root's parent is 0.
class MatCylinders {
public:
    /// @param path for diagnostics only.
    /// @param holder what holds the arrays, for diagnostics: "QSM(2).cylinder."
    MatCylinders(const Arrays& arrays, const ArrayNames& called, std::string path, std::string holder)
        : _path(std::move(path)), _holder(std::move(holder)), _radius(column(arrays, called.radius, 1)),
          _length(column(arrays, called.length, 1)), _start(column(arrays, called.start, 3)),
          _axis(column(arrays, called.axis, 3)), _parent(column(arrays, called.parent, 1)) {}

    /// The tree; the line of a cylinder is its number.
    Result<ScanCylinders> read() {
        ScanCylinders tree;
        std::vector<ScanName> links;
        std::size_t roots = 0;
        for (std::size_t row = 0; row < _rows && _problem.message.empty(); ++row) {
            tree.push_back(cylinder(row));
            links.push_back({tree.back().line, parent(row), tree.back().line});
            if (links.back().parent == 0 && ++roots > 1)
                fail(_parent, row, "expected one root, found another");
        }
        if (_problem.message.empty())
            if (const auto unlinked = linkCylinders(tree, links, 0, _path))
                fail(_parent, static_cast<std::size_t>(unlinked->line) - 1, unlinked->message);
        if (!_problem.message.empty())
            return _problem;
        return tree;
    }

private:
    /// An array as numbers, so many in each of its rows.
    struct Column {
        const char* name;
        std::size_t width;
        std::vector<double> values;
    };

    Column column(const Arrays& arrays, const char* name, std::size_t width) {
        const matvar_t* array = _problem.message.empty() ? arrays(name) : nullptr;
        std::vector<double> values = array ? numbers(*array) : std::vector<double>();
        if (_rows == 0) // the first, which all others are held against
            _rows = values.size();
        const bool isColumn = array && array->rank == 2 && (width == 1 || array->dims[0] == _rows);
        if (_problem.message.empty() && (!isColumn || _rows == 0 || values.size() != width * _rows))
            _problem = {_path, 0, 0, _holder + name,
                        "expected " + std::string(width == 3 ? "3 real numbers" : "a real number") +
                            " for each cylinder" +
                            (_rows > 0 ? " of " + std::to_string(_rows) : std::string())};
        if (_problem.message.empty() && _rows > maxScanCylinders)
            _problem = {_path, 0, 0, _holder + name,
                        "expected at most " + std::to_string(maxScanCylinders) + " cylinders"};
        return {name, width, std::move(values)};
    }

    double number(const Column& column, std::size_t row, std::size_t i, const ScanMeasure& measure) {
        const double value = column.values[row + i * _rows];
        if (!measure.range.contains(value))
            fail(column, row, expectedFound(measure.what, numberText(value)), i);
        return value;
    }

    glm::dvec3 vector(const Column& column, std::size_t row, const ScanMeasure& measure) {
        return {number(column, row, 0, measure), number(column, row, 1, measure),
                number(column, row, 2, measure)};
    }

    ScanCylinder cylinder(std::size_t row) {
        ScanCylinder cylinder;
        cylinder.radius = number(_radius, row, 0, scanRadius);
        const double length = number(_length, row, 0, scanLength);
        cylinder.start = vector(_start, row, scanMetres);
        const glm::dvec3 axis = vector(_axis, row, scanDirection);
        if (const std::string wrong = endAlong(axis, length, cylinder); !wrong.empty())
            fail(_axis, row, wrong);
        cylinder.line = static_cast<int>(row) + 1;
        return cylinder;
    }

    int parent(std::size_t row) {
        const ScanMeasure measure{"the number of a cylinder as parent, or 0", within(0.0, maxScanCylinders)};
        const double parent = number(_parent, row, 0, measure);
        if (!_problem.message.empty())
            return 0;
        if (parent != static_cast<int>(parent))
            fail(_parent, row, expectedFound(measure.what, numberText(parent)));
        return static_cast<int>(parent);
    }

    void fail(const Column& column, std::size_t row, const std::string& message, std::size_t i = 0) {
        if (!_problem.message.empty())
            return;
        const std::string place =
            std::to_string(row + 1) + (column.width > 1 ? ',' + std::to_string(i + 1) : "");
        _problem = {_path, 0, 0, _holder + column.name + '(' + place + ')', message};
    }

    const std::string _path, _holder;
    Diagnostic _problem; ///< The first.
    std::size_t _rows = 0;
    const Column _radius, _length, _start, _axis, _parent;
};

/// Finds trees in variables. The first problem is kept.
class TreeFinder {
public:
    explicit TreeFinder(const std::string& path) : _path(path) {}

    /// Takes all trees in a variable: of its cells, or its structs. @param depth of `variable` in the file's.
    void find(matvar_t* variable, const std::string& name, int depth = 0) {
        if (!variable || !variable->data || depth > mostDepth)
            return;
        const bool isCell = variable->class_type == MAT_C_CELL;
        if (!isCell && variable->class_type != MAT_C_STRUCT)
            return;
        const std::size_t count = elements(*variable);
        if (count > variable->nbytes / sizeof(matvar_t*))
            return;
        for (std::size_t i = 0; i < count && good(); ++i) {
            std::string element = name;
            if (isCell || count > 1)
                element.append(isCell ? "{" : "(").append(std::to_string(i + 1)).append(isCell ? "}" : ")");
            if (isCell)
                find(Mat_VarGetCell(variable, static_cast<int>(i)), element, depth + 1);
            else
                findInStruct(variable, i, element, depth);
        }
    }

    void take(const Arrays& arrays, const ArrayNames& called, const std::string& holder) {
        Result<ScanCylinders> tree = MatCylinders(arrays, called, _path, holder).read();
        if (!tree)
            _problem = tree.problems().front();
        else if ((_cylinders += tree.value().size()) > maxScanCylinders)
            _problem =
                fileProblem(_path, "expected at most " + std::to_string(maxScanCylinders) + " cylinders");
        else
            _scan.trees.push_back(std::move(tree.value()));
    }

    Result<ScanFile> result() {
        if (!good())
            return _problem;
        if (_scan.trees.empty())
            return fileProblem(_path, "expected TreeQSM's cylinders, as in QSM.cylinder; found none");
        return std::move(_scan);
    }

private:
    static constexpr int mostDepth = 4;

    static bool hasField(const matvar_t& variable, const std::string& name) {
        char* const* fields = Mat_VarGetStructFieldnames(&variable);
        const unsigned count = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable)); // it only looks
        return fields && std::find(fields, fields + count, name) != fields + count;
    }

    bool good() const { return _problem.message.empty(); }

    void findInStruct(matvar_t* variable, std::size_t i, const std::string& name, int depth) {
        const auto field = [&](const char* of) { return Mat_VarGetStructFieldByName(variable, of, i); };
        if (field(names.radius) && field(names.start))
            return take(field, names, name + '.');
        const std::size_t known = _scan.trees.size();
        find(field("cylinder"), name + ".cylinder", depth + 1);
        if (good() && known == _scan.trees.size() && hasField(*variable, "cylinder"))
            _problem = {_path, 0, 0, name + ".cylinder",
                        "expected a struct of radius, length, start, axis and parent"};
    }

    const std::string& _path;
    std::size_t _cylinders = 0;
    ScanFile _scan{"TreeQSM", {}};
    Diagnostic _problem;
};

} // namespace

Result<ScanFile> readTreeQsmMat(const MatFile& file, const std::string& path) {
    TreeFinder trees(path);
    if (file.variable(oldNames.radius) && file.variable(oldNames.start))
        trees.take([&](const char* name) { return file.variable(name); }, oldNames, {});
    for (matvar_t* variable : file.variables())
        trees.find(variable, variable->name ? variable->name : "");
    return trees.result();
}

} // namespace osgTreeWind
