// SPDX-License-Identifier: MIT
#include <plugins/matlab/TreeQsmMat.h>

#include <plugins/matlab/MatCylinders.h>

#include <osgTreeWind/base/Problem.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr MatCylinders::Names fieldNames{"radius", "length", "start", "axis", "parent"},
    version2Names{"Rad", "Len", "Sta", "Axe", "CPar"};

/// Finds the trees in variables, up to the first problem.
class TreeFinder {
public:
    explicit TreeFinder(const std::string& path) : _path(path) {}

    /// Finds all trees in the cells or structs of a variable. @param depth nesting level of `variable`.
    void find(matvar_t* variable, const std::string& name, int depth = 0) {
        if (!variable || !variable->data || depth > maxDepth)
            return;
        const bool isCell = variable->class_type == MAT_C_CELL;
        if (!isCell && variable->class_type != MAT_C_STRUCT)
            return;
        const std::size_t count = elementCount(*variable);
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

    void addTree(const MatCylinders::FindArray& findArray, const MatCylinders::Names& names,
                 const std::string& prefix) {
        Result<ScanCylinders> tree = MatCylinders(findArray, names, _path, prefix).read();
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
            return fileProblem(_path, "expected TreeQSM's cylinders, for example QSM.cylinder; found none");
        return std::move(_scan);
    }

private:
    static constexpr int maxDepth = 4;

    static bool hasField(const matvar_t& variable, const std::string& name) {
        char* const* fields = Mat_VarGetStructFieldnames(&variable);
        const unsigned count =
            Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable)); // does not modify it
        return fields && std::find(fields, fields + count, name) != fields + count;
    }

    bool good() const { return _problem.message.empty(); }

    void findInStruct(matvar_t* variable, std::size_t i, const std::string& name, int depth) {
        const auto field = [&](const char* of) { return Mat_VarGetStructFieldByName(variable, of, i); };
        if (field(fieldNames.radius) && field(fieldNames.start))
            return addTree(field, fieldNames, name + '.');
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
    if (file.variable(version2Names.radius) && file.variable(version2Names.start))
        trees.addTree([&](const char* name) { return file.variable(name); }, version2Names, {});
    for (matvar_t* variable : file.variables())
        trees.find(variable, variable->name ? variable->name : "");
    return trees.result();
}

} // namespace osgTreeWind
