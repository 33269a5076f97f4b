// SPDX-License-Identifier: MIT
#include <plugins/map/RasterFormats.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <cpl_minixml.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>

namespace osgTreeWind {
namespace {

namespace fs = std::filesystem;

constexpr int maxDepth = 8; // VRTs in VRTs

const char* const defaultFormats[] = {"GTiff", "COG",  "AAIGrid", "AIG",   "DTED", "SRTMHGT",
                                      "HFA",   "GSAG", "GSBG",    "GS7BG", "VRT"};

bool isAllowedFormat(const char* format) {
    const auto& formats = rasterFormats();
    return std::any_of(formats.begin(), formats.end() - 1,
                       [&](const char* known) { return EQUAL(known, format); });
}

/// The regular file with the data of a GDAL path, such as the archive of /vsizip/; empty if there is none.
std::string findContainingFile(std::string path) {
    bool isPacked = false;
    for (const char* const prefix : {"/vsizip/", "/vsigzip/"})
        if (path.rfind(prefix, 0) == 0) {
            path.erase(0, std::strlen(prefix));
            isPacked = true;
        }
    if (path.rfind("/vsi", 0) == 0)
        return {};
    std::error_code ignored;
    for (fs::path file = toPath(path); isPacked && file.has_relative_path(); file = file.parent_path())
        if (fs::is_regular_file(file, ignored))
            return toText(file);
    return fs::is_regular_file(toPath(path), ignored) ? path : std::string();
}

/// Checks a VRT and those it refers to.
class Vrt {
public:
    explicit Vrt(const std::string& path, int depth = 0) : _path(path), _depth(depth) {}

    std::string problem() const {
        const std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)> root(CPLParseXMLFile(_path.c_str()),
                                                                             &CPLDestroyXMLNode);
        return root ? problemOf(root.get()) : std::string();
    }

private:
    /// Checks a node, its children and its next siblings.
    std::string problemOf(const CPLXMLNode* first) const {
        for (const CPLXMLNode* node = first; node; node = node->psNext) {
            if (node->eType != CXT_Element)
                continue;
            std::string problem = elementProblem(*node);
            if (problem.empty())
                problem = problemOf(node->psChild);
            if (!problem.empty())
                return problem;
        }
        return {};
    }

    std::string elementProblem(const CPLXMLNode& node) const {
        const std::string kind = CPLGetXMLValue(&node, "subClass", "VRTSourcedRasterBand");
        if ((EQUAL(node.pszValue, "VRTDataset") || EQUAL(node.pszValue, "VRTRasterBand")) &&
            kind != "VRTSourcedRasterBand")
            return "expected a VRT that combines files, found one with " + inQuotes(kind);
        if (EQUAL(node.pszValue, "Group"))
            return "expected a VRT of bands, found a multidimensional one";
        if (EQUAL(node.pszValue, "SourceFilename") || EQUAL(node.pszValue, "SourceDataset"))
            return sourceProblem(CPLGetXMLValue(&node, nullptr, ""),
                                 std::atoi(CPLGetXMLValue(&node, "relativeToVRT", "0")) != 0);
        return {};
    }

    std::string sourceProblem(const std::string& name, bool isRelative) const {
        const std::string folder = folderOf(_path),
                          path = isRelative ? toText(toPath(folder) / toPath(name)) : name,
                          named = "its source " + inQuotes(name) + ' ';
        if (const std::string problem = problemOfNaming(name, {folder}); !problem.empty())
            return named + problem;
        const std::string file = findContainingFile(path);
        if (file.empty())
            return named + "is not a file";
        if (const std::string problem = problemOfTrust(file, {folder}); !problem.empty())
            return named + problem;
        const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
        const char* const format = driver ? GDALGetDriverShortName(driver) : "";
        if (!isAllowedFormat(format))
            return named + "has a format that is not supported for ground";
        if (!EQUAL(format, "VRT"))
            return {};
        return _depth < maxDepth ? Vrt(path, _depth + 1).problem() : named + "is a VRT nested too deeply";
    }

    std::string _path;
    int _depth;
};

} // namespace

const std::vector<const char*>& rasterFormats() {
    static std::vector<std::string> extraFormats;
    static const std::vector<const char*> formats = [] {
        std::istringstream names(environmentVariable("OSGTREEWIND_GDAL_DRIVERS").value_or(""));
        for (std::string name; std::getline(names, name, ',');)
            if (!name.empty())
                extraFormats.push_back(name);
        std::vector<const char*> all(std::begin(defaultFormats), std::end(defaultFormats));
        for (const std::string& name : extraFormats)
            all.push_back(name.c_str());
        all.push_back(nullptr);
        return all;
    }();
    return formats;
}

void deregisterOtherRasterDrivers() {
    for (int i = GDALGetDriverCount() - 1; i >= 0; --i) {
        const GDALDriverH driver = GDALGetDriver(i);
        if (GDALGetMetadataItem(driver, GDAL_DCAP_RASTER, nullptr) &&
            !GDALGetMetadataItem(driver, GDAL_DCAP_VECTOR, nullptr) &&
            !isAllowedFormat(GDALGetDriverShortName(driver)))
            GDALDeregisterDriver(driver);
    }
}

std::string problemOfRaster(const std::string& path) {
    const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
    const char* const format = driver ? GDALGetDriverShortName(driver) : "";
    if (driver && !isAllowedFormat(format))
        return std::string("expected a format of docs/treewind.md, found ") + format +
               "; gdal_translate converts it to GeoTIFF";
    return EQUAL(format, "VRT") ? Vrt(path).problem() : std::string();
}

} // namespace osgTreeWind
