// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TextTokens.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <cctype>
#include <map>

namespace osgTreeWind {

namespace {

struct EsriHeader {
    std::map<std::string, double> values;

    bool has(const char* key) const { return values.count(key) != 0; }
    double of(const char* key) const { return values.at(key); }
};

/// Reads keys and values until a line begins with a number.
EsriHeader readHeader(TextTokens& tokens, std::string_view text) {
    EsriHeader header;
    while (tokens.good()) {
        TextTokens ahead = tokens;
        const std::string_view word = ahead.next();
        if (word.empty() || !std::isalpha(static_cast<unsigned char>(word.front())))
            break;
        const std::string key = lower(std::string(tokens.next()));
        const bool size = key == "ncols" || key == "nrows";
        if (size)
            header.values[key] = tokens.integer("a number of cells from 1 to 100000", 1, 100000);
        else if (key == "cellsize")
            header.values[key] = tokens.number("metres above 0", 1e-6, maxCoordinate);
        else if (key == "nodata_value")
            header.values[key] = tokens.number("a number", -1e300, 1e300);
        else if (key == "xllcorner" || key == "yllcorner" || key == "xllcenter" || key == "yllcenter")
            header.values[key] = tokens.number("metres within 1e9", -maxCoordinate, maxCoordinate);
        else
            tokens.fail(expectedFound("a key of an ESRI ASCII grid", key));
    }
    for (const char* key : {"ncols", "nrows", "cellsize"})
        if (!header.has(key))
            tokens.fail("expected " + std::string(key) + " in the header");
    for (const char* axis : {"x", "y"})
        if (header.has((axis + std::string("llcorner")).c_str()) ==
            header.has((axis + std::string("llcenter")).c_str()))
            tokens.fail("expected either " + std::string(axis) + "llcorner or " + axis +
                        "llcenter in the header");
    if (tokens.good() && header.of("ncols") * header.of("nrows") * 2 > static_cast<double>(text.size()) + 1)
        tokens.fail("the file is too short for " + numberText(header.of("ncols")) + " x " +
                    numberText(header.of("nrows")) + " cells");
    return header;
}

double firstCentre(const EsriHeader& header, const std::string& axis) {
    const std::string corner = axis + "llcorner", centre = axis + "llcenter";
    return header.has(corner.c_str()) ? header.of(corner.c_str()) + 0.5 * header.of("cellsize")
                                      : header.of(centre.c_str());
}

} // namespace

Result<RasterBand> readEsriGrid(std::string_view text, const std::string& file) {
    TextTokens tokens(text, file);
    const EsriHeader header = readHeader(tokens, text);
    if (!tokens.good())
        return tokens.problem();
    RasterBand grid;
    grid.cells = {header.of("ncols"), header.of("nrows")};
    grid.cellSize = header.of("cellsize");
    grid.southWest = {firstCentre(header, "x"), firstCentre(header, "y")};
    const auto columns = static_cast<std::size_t>(grid.cells.x),
               rows = static_cast<std::size_t>(grid.cells.y);
    const double missing = header.has("nodata_value") ? header.of("nodata_value") : -9999.0;
    grid.values.resize(columns * rows);
    for (std::size_t row = rows; row-- > 0;)
        for (std::size_t column = 0; column < columns; ++column) {
            const double value = tokens.number("a number", -1e30, 1e30);
            grid.values[row * columns + column] = value == missing ? noData : static_cast<float>(value);
            if (!tokens.good())
                return tokens.problem();
        }
    if (const std::string_view extra = tokens.next(); !extra.empty())
        tokens.fail(expectedFound("the end after " + std::to_string(columns * rows) + " cells", extra));
    if (!tokens.good())
        return tokens.problem();
    return grid;
}

} // namespace osgTreeWind
