// SPDX-License-Identifier: MIT
#include <plugins/map/CityJson.h>

#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/system/Path.h>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cpl_json.h>
#include <gdal.h>
#include <ogr_api.h>

#include <fstream>
#include <optional>
#include <regex>
#include <unordered_map>

// GDAL has no driver for CityJSON, but a JSON parser.
namespace osgTreeWind {

namespace {

using Type = CPLJSONObject::Type;

bool isNumber(const CPLJSONObject& value) {
    return value.GetType() == Type::Integer || value.GetType() == Type::Long ||
           value.GetType() == Type::Double;
}

/// A vector from an array of three numbers; empty for other values.
std::optional<glm::dvec3> parseVector(const CPLJSONObject& value) {
    const CPLJSONArray array = value.ToArray();
    if (!array.IsValid() || array.Size() < 3)
        return std::nullopt;
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) {
        if (!isNumber(array[i]))
            return std::nullopt;
        vector[i] = array[i].ToDouble();
    }
    return vector;
}

class CityReader {
public:
    CityReader(const std::string& path, const CPLJSONObject& root)
        : _path(path), _root(root), _vertices(root.GetArray("vertices")) {
        _scale = parseVector(root.GetObj("transform/scale")).value_or(glm::dvec3(1.0));
        _translation = parseVector(root.GetObj("transform/translate")).value_or(glm::dvec3(0.0));
    }

    Result<std::shared_ptr<void>> read() {
        std::string system = _root.GetString("metadata/referenceSystem");
        const Result<GdalCrs> crs = system.empty() ? GdalCrs() : GdalCrs::parse(system);
        if (!crs)
            return fileProblem(_path, crs.problems().front().message);
        std::shared_ptr<void> data(
            GDALCreate(GDALGetDriverByName("Memory"), "", 0, 0, 0, GDT_Unknown, nullptr),
            [](void* made) { GDALClose(made); });
        _layer = GDALDatasetCreateLayer(data.get(), "SolitaryVegetationObject", crs.value().reference(),
                                        wkbPoint25D, nullptr);
        field("id", OFTString);
        for (const CPLJSONObject& object : _root.GetObj("CityObjects").GetChildren())
            if (object.GetString("type") == "SolitaryVegetationObject")
                add(object);
        if (!_isComplete)
            return fileProblem(_path, "its features do not fit into memory");
        return data;
    }

private:
    int field(const std::string& name, OGRFieldType type) {
        const auto [known, isNew] = _fields.emplace(name, static_cast<int>(_fields.size()));
        if (!isNew)
            return known->second;
        const OGRFieldDefnH made = OGR_Fld_Create(name.c_str(), type);
        OGR_L_CreateField(_layer, made, true);
        OGR_Fld_Destroy(made);
        return known->second;
    }

    void add(const CPLJSONObject& object) {
        const std::vector<CPLJSONObject> attributes = object.GetObj("attributes").GetChildren();
        for (const CPLJSONObject& attribute : attributes)
            field(attribute.GetName(), isNumber(attribute) ? OFTReal : OFTString);
        const OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(_layer));
        for (const CPLJSONObject& attribute : attributes)
            if (attribute.GetType() != Type::Null)
                OGR_F_SetFieldString(feature, field(attribute.GetName(), OFTString),
                                     attribute.ToString().c_str());
        OGR_F_SetFieldString(feature, 0, object.GetName().c_str());
        if (const auto foot = findFoot(object.GetArray("geometry"))) {
            const OGRGeometryH point = OGR_G_CreateGeometry(wkbPoint25D);
            OGR_G_SetPoint(point, 0, foot->x, foot->y, foot->z);
            OGR_F_SetGeometryDirectly(feature, point);
        }
        _isComplete &= OGR_L_CreateFeature(_layer, feature) == OGRERR_NONE;
        OGR_F_Destroy(feature);
    }

    /// The foot of the first geometry: below the middle of its box, moved by the matrix of an instance.
    std::optional<glm::dvec3> findFoot(const CPLJSONArray& geometries) {
        if (!geometries.IsValid() || geometries.Size() == 0)
            return std::nullopt;
        const CPLJSONObject geometry = geometries[0];
        _low.reset();
        if (!expandBox(geometry.GetObj("boundaries")) || !_low)
            return std::nullopt;
        glm::dvec3 foot{0.5 * (_low->x + _high.x), 0.5 * (_low->y + _high.y), _low->z};
        const CPLJSONArray matrix = geometry.GetArray("transformationMatrix");
        if (matrix.IsValid() && matrix.Size() == 16)
            foot += glm::dvec3(matrix[3].ToDouble(), matrix[7].ToDouble(), matrix[11].ToDouble());
        return foot;
    }

    /// Expands the box by the vertices of nested boundaries. @return false for an invalid vertex.
    bool expandBox(const CPLJSONObject& boundaries) {
        if (boundaries.GetType() == Type::Array) {
            const CPLJSONArray parts = boundaries.ToArray();
            for (int i = 0; i < parts.Size(); ++i)
                if (!expandBox(parts[i]))
                    return false;
            return true;
        }
        const int index = boundaries.ToInteger(-1);
        const auto stored = boundaries.GetType() == Type::Integer && index >= 0 && _vertices.IsValid() &&
                                    index < _vertices.Size()
                                ? parseVector(_vertices[index])
                                : std::nullopt;
        if (!stored)
            return false;
        const glm::dvec3 vertex = *stored * _scale + _translation;
        _high = _low ? glm::max(_high, vertex) : vertex;
        _low = _low ? glm::min(*_low, vertex) : vertex;
        return true;
    }

    const std::string& _path;
    const CPLJSONObject& _root;
    CPLJSONArray _vertices;
    glm::dvec3 _scale, _translation, _high{0.0};
    std::optional<glm::dvec3> _low;
    OGRLayerH _layer = nullptr;
    std::unordered_map<std::string, int> _fields; ///< Column by name.
    bool _isComplete = true;
};

} // namespace

bool isCityJson(const std::string& path) {
    std::ifstream file(toPath(path), std::ios::binary);
    const std::string head = readHead(file, 65536);
    static const std::regex type(R"("type"\s*:\s*"CityJSON")");
    return head.find("\"CityJSON\"") != std::string::npos && std::regex_search(head, type);
}

Result<std::shared_ptr<void>> readCityJson(const std::string& path) {
    const GdalErrors errors;
    const Result<std::string> text = readTextFile(path);
    if (!text)
        return text.problems();
    CPLJSONDocument document;
    if (!document.LoadMemory(text.value()))
        return fileProblem(path, "cannot be read: " + errors.textOr("not JSON"));
    const CPLJSONObject root = document.GetRoot();
    if (!root.GetObj("CityObjects").IsValid())
        return fileProblem(path, "expected CityObjects in a CityJSON file");
    return CityReader(path, root).read();
}

} // namespace osgTreeWind
