// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <string>
#include <vector>

/// Throws CommandError unless a drawing can be written to the path, which ends in .svg or .png.
/// @param option that gave the path.
void checkDrawingPath(const std::string& option, const std::string& path);

/// A drawing of lines, circles and text on white, written as SVG or PNG. Places are in pixels from the upper
/// left corner, colours in sRGB from 0 to 1.
class Drawing {
public:
    enum class Align { Left, Centre, Right };
    static constexpr glm::vec3 black{0.1f}; ///< Of text and axes.

    /// @param path as for checkDrawingPath().
    Drawing(const std::string& path, const glm::dvec2& size);
    ~Drawing();

    void setColour(const glm::vec3& colour);
    void fillCircle(const glm::dvec2& centre, double radius);
    void fillRectangle(const glm::dvec2& corner, const glm::dvec2& size);
    void drawCircle(const glm::dvec2& centre, double radius);
    void drawLine(const std::vector<glm::dvec2>& points, double width = 1.0);
    /// Writes a line of UTF-8. @param place of its middle height. @param upward whether it runs upward.
    void write(const std::string& text, const glm::dvec2& place, Align align, double height = 13.0,
               bool upward = false);
    /// Writes the file. Throws CommandError on failure.
    void finish();

private:
    struct Surface;
    std::string _path;
    std::unique_ptr<Surface> _surface;
};

/// Round numbers that divide a range into at most `most` steps.
std::vector<double> ticksOf(double low, double high, int most);
std::string tickText(double tick); ///< With up to 6 digits.
