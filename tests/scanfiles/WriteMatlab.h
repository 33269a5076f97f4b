// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <matio.h>

#include <cstdint>
#include <string>
#include <vector>

/// Writes .mat files like those of MATLAB and TreeQSM, with libmatio.
namespace osgTreeWind {

/// A version of .mat and its compression.
struct MatVersion {
    const char* name;
    mat_ft version;
    matio_compression compression;
};

constexpr MatVersion matVersions[] = {{"v6", MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                                      {"v7", MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                                      {"v73", MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}};

inline void PrintTo(const MatVersion& version, std::ostream* out) {
    *out << version.name;
}

template <typename T>
matvar_t* matColumns(const std::string& name, std::vector<T> values, std::size_t columns = 1) {
    std::size_t sizes[] = {values.size() / columns, columns};
    const bool isDouble = std::is_same_v<T, double>, isFloat = std::is_same_v<T, float>;
    return Mat_VarCreate(name.c_str(),
                         isDouble  ? MAT_C_DOUBLE
                         : isFloat ? MAT_C_SINGLE
                                   : MAT_C_UINT32,
                         isDouble  ? MAT_T_DOUBLE
                         : isFloat ? MAT_T_SINGLE
                                   : MAT_T_UINT32,
                         2, sizes, values.data(), 0);
}

/// The arrays of TreeQSM's cylinders.
struct QsmArrays {
    std::vector<double> radius, length, start, axis; ///< Start and axis: all x, then all y, then all z.
    std::vector<std::uint32_t> parent;

    explicit QsmArrays(const ScanCylinders& tree) {
        for (const ScanCylinder& cylinder : tree) {
            radius.push_back(cylinder.radius);
            length.push_back(glm::distance(cylinder.start, cylinder.end));
            parent.push_back(static_cast<std::uint32_t>(cylinder.parent + 1));
        }
        for (int i = 0; i < 3; ++i)
            for (const ScanCylinder& cylinder : tree) {
                start.push_back(cylinder.start[i]);
                axis.push_back(glm::normalize(cylinder.end - cylinder.start)[i]);
            }
    }

    /// As variables, or fields of a struct.
    std::vector<matvar_t*> variables(const std::vector<std::string>& names) const {
        return {matColumns(names[0], radius), matColumns(names[1], length), matColumns(names[2], start, 3),
                matColumns(names[3], axis, 3), matColumns(names[4], parent)};
    }
};

inline const std::vector<std::string> qsmNames = {"radius", "length", "start", "axis", "parent"};

/// An array of structs with these fields; all values of the first struct come first.
inline matvar_t* matStruct(const std::string& name, const std::vector<std::string>& fields,
                           const std::vector<matvar_t*>& values) {
    std::vector<const char*> names;
    for (const std::string& field : fields)
        names.push_back(field.c_str());
    std::size_t sizes[] = {1, values.size() / fields.size()};
    // Deprecated in libmatio 1.6 for Mat_VarCreateStruct2(), which 1.5.28 lacks.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
    matvar_t* made =
        Mat_VarCreateStruct(name.c_str(), 2, sizes, names.data(), static_cast<unsigned>(fields.size()));
#pragma GCC diagnostic pop
    for (std::size_t i = 0; i < values.size(); ++i)
        Mat_VarSetStructFieldByIndex(made, i % fields.size(), i / fields.size(), values[i]);
    return made;
}

inline matvar_t* matCell(const std::string& name, const std::vector<matvar_t*>& values) {
    std::size_t sizes[] = {1, values.size()};
    std::vector<matvar_t*> cells = values;
    return Mat_VarCreate(name.c_str(), MAT_C_CELL, MAT_T_CELL, 2, sizes, cells.data(), 0);
}

/// TreeQSM's array of structs, one per tree.
inline matvar_t* qsmStruct(const std::string& name, const std::vector<QsmArrays>& trees) {
    std::vector<matvar_t*> values;
    for (const QsmArrays& tree : trees) {
        values.push_back(matStruct("cylinder", qsmNames, tree.variables(qsmNames)));
        values.push_back(matStruct("treedata", {"TotalVolume"}, {matColumns("", std::vector<double>{4.1})}));
    }
    return matStruct(name, {"cylinder", "treedata"}, values);
}

/// Writes and frees the variables. @return the path.
inline std::string writeMat(const std::string& path, const MatVersion& version,
                            const std::vector<matvar_t*>& variables) {
    mat_t* file = Mat_CreateVer(path.c_str(), nullptr, version.version);
    EXPECT_NE(file, nullptr) << path;
    for (matvar_t* variable : variables) {
        EXPECT_EQ(Mat_VarWrite(file, variable, version.compression), 0);
        Mat_VarFree(variable);
    }
    Mat_Close(file);
    return path;
}

} // namespace osgTreeWind
