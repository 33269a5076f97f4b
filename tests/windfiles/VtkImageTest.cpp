// SPDX-License-Identifier: MIT
// Which arrays of a VTK file are the wind.
#include <tests/base/FirstProblem.h>
#include <tests/windfiles/Notes.h>

#include <osgTreeWind/windfiles/WindFormats.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace osgTreeWind {

namespace {

using Names = std::vector<std::string>;

/// An array of 2 points or cells. The first component of each is `value`, the others are 0.
struct Array {
    std::string name;
    int value = 0, components = 3;
};

std::string numbersOf(const Array& array) {
    std::string numbers;
    for (int i = 0; i < 2 * array.components; ++i)
        numbers += std::to_string(i % array.components == 0 ? array.value : 0) + ' ';
    return numbers;
}

std::string xmlOf(const std::string& place, const std::string& attributes, const std::vector<Array>& arrays) {
    std::string text = '<' + place + ' ' + attributes + '>';
    for (const Array& array : arrays)
        text += "<DataArray type='Float32' Name='" + array.name + "' NumberOfComponents='" +
                std::to_string(array.components) + "'>" + numbersOf(array) + "</DataArray>";
    return text + "</" + place + '>';
}

/// Image data of 3 points, and so of 2 cells, or of 2 points.
Result<WindContent> readXml(const std::string& arrays, const Names& variable = {}, int lastPoint = 1) {
    const std::string extent = "Extent='0 " + std::to_string(lastPoint) + " 0 0 0 0'>";
    return readVtkXml("<VTKFile type='ImageData'><ImageData Whole" + extent + "<Piece " + extent + arrays +
                          "</Piece></ImageData></VTKFile>",
                      "f", variable);
}

Result<WindContent> readPoints(const std::vector<Array>& arrays, const std::string& attributes = "",
                               const Names& variable = {}) {
    return readXml(xmlOf("PointData", attributes, arrays), variable);
}

Result<WindContent> readLegacy(const std::string& sections, const Names& variable = {}) {
    return readVtkLegacy("# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\n"
                         "ORIGIN 0 0 3\nSPACING 10 1 1\nPOINT_DATA 2\n" +
                             sections,
                         "f", variable);
}

/// The velocity of the first point or cell; -1 after a problem.
glm::vec3 velocityOf(const Result<WindContent>& read) {
    EXPECT_TRUE(read) << firstProblem(read);
    if (!read)
        return glm::vec3(-1.0f);
    const std::vector<float>& values = std::get<GridWind::Grid>(read.value().data).values;
    EXPECT_EQ(values.size(), 6u);
    return {values[0], values[1], values[2]};
}

void expectProblem(const Result<WindContent>& read, const std::string& part) {
    EXPECT_NE(firstProblem(read).find(part), std::string::npos) << firstProblem(read);
}

} // namespace

TEST(VtkImage, TakesTheActiveVectorsBeforeTheUsualNames) {
    const auto read = readPoints({{"C", 1}, {"U", 2}, {"UMean", 3}}, "Vectors='UMean'");
    EXPECT_EQ(velocityOf(read).x, 3);
    EXPECT_TRUE(
        hasNote(read.value().summary, "point vectors 'UMean'; wind.variable chooses another of C, U"));
    EXPECT_EQ(velocityOf(readLegacy("VECTORS a float\n1 0 0 1 0 0\nFIELD f 1\nU 3 2 float\n2 0 0 2 0 0\n")).x,
              1)
        << "VECTORS of a legacy file are active";
    EXPECT_EQ(velocityOf(readXml(xmlOf("PointData", "Vectors='V'", {{"V", 1}}) +
                                 xmlOf("CellData", "Vectors='W'", {{"W", 2}})))
                  .x,
              1)
        << "points go before cells";
}

TEST(VtkImage, TakesTheUsualNamesInAnyOrderAndCase) {
    EXPECT_EQ(velocityOf(readPoints({{"C", 1}, {"U", 2}})).x, 2);
    EXPECT_EQ(velocityOf(readPoints({{"UMean", 1}, {"vorticity", 2}, {"U", 3}})).x, 3);
    EXPECT_EQ(velocityOf(readPoints({{"WIND", 1}, {"a", 2}, {"Velocity", 3}})).x, 3);
    EXPECT_EQ(velocityOf(readPoints({{"a", 1}, {"Wind", 2}})).x, 2);
    EXPECT_EQ(velocityOf(readLegacy("FIELD f 2\nC 3 2 float\n1 0 0 1 0 0\nu 3 2 double\n2 0 0 2 0 0\n")).x,
              2);
    EXPECT_EQ(velocityOf(readLegacy("VECTORS C float\n1 0 0 1 0 0\nVECTORS velocity float\n2 0 0 2 0 0\n")).x,
              2)
        << "of several VECTORS, none is active";
    EXPECT_EQ(velocityOf(
                  readXml(xmlOf("PointData", "", {{"C", 1}}) + xmlOf("CellData", "", {{"U", 2}, {"p", 3, 1}}),
                          {}, 2))
                  .x,
              2)
        << "U of the cells";
}

TEST(VtkImage, TakesTheOnlyVectors) {
    const auto read = readPoints({{"p", 1, 1}, {"flow", 2}});
    EXPECT_EQ(velocityOf(read).x, 2);
    EXPECT_TRUE(hasNote(read.value().summary, "point vectors 'flow'"));
    EXPECT_EQ(velocityOf(readPoints({{"n", 1}, {"flow", 2}}, "Normals='n'")).x, 2);
    EXPECT_EQ(
        velocityOf(readLegacy("NORMALS n float\n0 0 1 0 0 1\nSCALARS flow float 3\nLOOKUP_TABLE default\n"
                              "2 0 0 2 0 0\n"))
            .x,
        2);
}

TEST(VtkImage, RefusesAChoiceWithTheListOfArrays) {
    const std::string names =
        "named U, velocity or wind; found UMean (3), p (1), Normals (3); wind.variable names";
    expectProblem(readPoints({{"UMean", 1}, {"p", 2, 1}, {"Normals", 3}}), names);
    expectProblem(readLegacy("FIELD f 3\nUMean 3 2 float\n1 0 0 1 0 0\np 1 2 float\n1 1\n"
                             "Normals 3 2 float\n0 0 1 0 0 1\n"),
                  names);
    expectProblem(readPoints({{"U", 1}, {"u", 2}}), "found U (3), u (3);");
    expectProblem(readPoints({{"u", 1, 1}, {"v", 2, 1}}), "found u (1), v (1); wind.variable names the wind");
    expectProblem(readPoints({}), "found none");
}

TEST(VtkImage, TakesTheNamedVectors) {
    EXPECT_EQ(velocityOf(readPoints({{"U", 1}, {"UMean", 2}}, "Vectors='U'", {"UMean"})).x, 2);
    const std::string legacy = "VECTORS a float\n1 0 0 1 0 0\nFIELD f 1\nb 3 2 float\n2 0 0 2 0 0\n";
    EXPECT_EQ(velocityOf(readLegacy(legacy, {"b"})).x, 2);
    expectProblem(readLegacy(legacy, {"B"}), "that wind.variable names; found a (3), b (3)");
    expectProblem(readPoints({{"u", 1, 1}}, "", {"u"}), "found u (1)");
}

TEST(VtkImage, TakesTheNamedComponents) {
    const std::vector<Array> arrays = {{"w", 3, 1}, {"v", 2, 1}, {"u", 1, 1}};
    EXPECT_EQ(velocityOf(readPoints(arrays, "", {"u", "v", "w"})), glm::vec3(1, 2, 3));
    const auto flat = readPoints(arrays, "", {"u", "v"});
    EXPECT_EQ(velocityOf(flat), glm::vec3(1, 2, 0));
    EXPECT_TRUE(hasNote(flat.value().summary, "point vectors 'u, v'"));
    EXPECT_EQ(velocityOf(readLegacy(
                  "SCALARS u float\nLOOKUP_TABLE default\n1 1\nFIELD f 1\nv 1 2 float\n2 2\n", {"u", "v"})),
              glm::vec3(1, 2, 0));
    expectProblem(readPoints(arrays, "", {"u", "z"}), "that wind.variable names; found w (1), v (1), u (1)");
}

} // namespace osgTreeWind
