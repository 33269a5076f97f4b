// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/Drawing.h>

#include <osgTreeWind/base/PortableMath.h>

#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/CommandError.h>

#include <glm/gtc/constants.hpp>

#include <osgDB/FileNameUtils>

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace math = osgTreeWind::math;

namespace {

bool isSvg(const std::string& path) {
    return osgDB::getLowerCaseFileExtension(path) == "svg";
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned size) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
}

} // namespace

struct Drawing::Surface {
    Surface(bool vector, const glm::dvec2& size)
        : surface(vector ? cairo_svg_surface_create_for_stream(append, &bytes, size.x, size.y)
                         : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.x),
                                                      static_cast<int>(size.y))),
          context(cairo_create(surface)) {
        cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
        cairo_paint(context);
        cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
        cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    }
    ~Surface() {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    std::string bytes;
    cairo_surface_t* surface;
    cairo_t* context;
};

void checkDrawingPath(const std::string& option, const std::string& path) {
    const std::string extension = osgDB::getLowerCaseFileExtension(path);
    if (extension != "svg" && extension != "png")
        throw CommandError{BadInput, option + ": expected a name that ends in .svg or .png, found " + path};
    checkOutputPath(path);
}

Drawing::Drawing(const std::string& path, const glm::dvec2& size)
    : _path(path), _surface(std::make_unique<Surface>(isSvg(path), size)) {}

Drawing::~Drawing() = default;

void Drawing::setColour(const glm::vec3& colour) {
    cairo_set_source_rgb(_surface->context, static_cast<double>(colour.r), static_cast<double>(colour.g),
                         static_cast<double>(colour.b));
}

void Drawing::fillCircle(const glm::dvec2& centre, double radius) {
    cairo_arc(_surface->context, centre.x, centre.y, radius, 0.0, glm::two_pi<double>());
    cairo_fill(_surface->context);
}

void Drawing::drawCircle(const glm::dvec2& centre, double radius) {
    cairo_set_line_width(_surface->context, 1.0);
    cairo_arc(_surface->context, centre.x, centre.y, radius, 0.0, glm::two_pi<double>());
    cairo_stroke(_surface->context);
}

void Drawing::fillRectangle(const glm::dvec2& corner, const glm::dvec2& size) {
    cairo_rectangle(_surface->context, corner.x, corner.y, size.x, size.y);
    cairo_fill(_surface->context);
}

void Drawing::drawLine(const std::vector<glm::dvec2>& points, double width) {
    cairo_set_line_width(_surface->context, width);
    for (const glm::dvec2& point : points)
        cairo_line_to(_surface->context, point.x, point.y);
    cairo_stroke(_surface->context);
}

void Drawing::write(const std::string& text, const glm::dvec2& place, Align align, double height,
                    bool upward) {
    cairo_t* const context = _surface->context;
    cairo_set_font_size(context, height);
    cairo_text_extents_t extent;
    cairo_text_extents(context, text.c_str(), &extent);
    const double share = align == Align::Left ? 0.0 : align == Align::Centre ? 0.5 : 1.0;
    cairo_save(context);
    cairo_translate(context, place.x, place.y);
    if (upward)
        cairo_rotate(context, -glm::half_pi<double>());
    cairo_move_to(context, -share * extent.x_advance, 0.35 * height);
    cairo_show_text(context, text.c_str());
    cairo_new_path(context);
    cairo_restore(context);
}

void Drawing::finish() {
    if (!isSvg(_path))
        cairo_surface_write_to_png_stream(_surface->surface, append, &_surface->bytes);
    cairo_surface_finish(_surface->surface);
    if (const cairo_status_t status = cairo_status(_surface->context); status != CAIRO_STATUS_SUCCESS)
        throw CommandError{Failed, _path + ": " + cairo_status_to_string(status)};
    writeOrThrow(_path, _surface->bytes);
}

std::vector<double> ticksOf(double low, double high, int most) {
    const double rough = std::max((high - low) / most, 1e-12);
    double step = math::pow(10.0, std::floor(math::log10(rough)));
    for (const double factor : {2.0, 2.5, 2.0}) // 1, 2, 5, 10
        step *= step < rough ? factor : 1.0;
    std::vector<double> ticks;
    for (double i = std::ceil(low / step - 1e-9); i <= std::floor(high / step + 1e-9); ++i)
        ticks.push_back(std::abs(i) < 0.5 ? 0.0 : step * i);
    return ticks;
}

std::string tickText(double tick) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", tick);
    return text;
}
