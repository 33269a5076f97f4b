// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorCache.h>

#include <osgTreeWind/base/Digest.h>
#include <osgTreeWind/drawing/looks/PictureCache.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <cstring>
#include <optional>
#include <string>

namespace osgTreeWind {
namespace {

/// Precedes the extents, the colours and the normals.
struct Header {
    std::int32_t azimuths, elevations, pixels;
    float halfWidth, height;
};

static_assert(sizeof(LeafCluster) == 36 && sizeof(LeafVertex) == 32 && sizeof(BranchUnit) == 44,
              "a digest needs structs without padding");

PaintedBytes cacheOf(const TreeModel& model, Appearance appearance, const ImpostorSettings& settings) {
    std::string work = "impostor";
    for (const osg::ref_ptr<osg::Image>& texture : {leafImage(appearance), barkImage(appearance)})
        work += ' ' + texture->getName();
    appearance.leafImage.clear(); // paths do not matter
    appearance.barkImage.clear();
    addKeyBytes(appearance, work);
    Digest tree;
    tree.add(model.leaves);
    tree.add(model.leafMesh);
    tree.add(model.skeleton.units);
    tree.add(model.skeleton.points);
    tree.add(model.skeleton.ringsPerBranch);
    tree.add(settings);
    return PaintedBytes(work + tree.bytes());
}

std::string bytesOf(const ImpostorPictures& pictures) {
    const Header head{pictures.azimuths, pictures.elevations, pictures.pixels, pictures.halfWidth,
                      pictures.height};
    std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
    bytes.append(reinterpret_cast<const char*>(pictures.extents.data()),
                 pictures.extents.size() * sizeof(glm::vec2));
    appendImage(*pictures.colors, bytes);
    appendImage(*pictures.normals, bytes);
    return bytes;
}

/// Nullopt if the bytes are not pictures for these settings.
std::optional<ImpostorPictures> picturesOf(const std::string& bytes, const ImpostorSettings& settings) {
    Header head{};
    std::vector<glm::vec2> extents(static_cast<std::size_t>(settings.elevations));
    std::size_t place = sizeof head + extents.size() * sizeof(glm::vec2);
    if (bytes.size() < place)
        return std::nullopt;
    std::memcpy(&head, bytes.data(), sizeof head);
    std::memcpy(extents.data(), bytes.data() + sizeof head, place - sizeof head);
    if (head.azimuths != settings.azimuths || head.elevations != settings.elevations ||
        head.pixels != settings.pixels || !(head.halfWidth > 0.0f) || !(head.height > 0.0f))
        return std::nullopt;
    ImpostorPictures pictures;
    pictures.azimuths = head.azimuths;
    pictures.elevations = head.elevations;
    pictures.pixels = head.pixels;
    pictures.halfWidth = head.halfWidth;
    pictures.height = head.height;
    pictures.extents = std::move(extents);
    for (osg::ref_ptr<osg::Image>* image : {&pictures.colors, &pictures.normals}) {
        *image = takeImage(bytes, place);
        if (!*image || (*image)->s() != head.azimuths * head.pixels ||
            (*image)->t() != head.elevations * head.pixels)
            return std::nullopt;
    }
    return place == bytes.size() ? std::optional(std::move(pictures)) : std::nullopt;
}

} // namespace

ImpostorPictures cachedImpostor(const TreeModel& model, const Appearance& appearance,
                                const ImpostorSettings& settings) {
    const PaintedBytes cached = cacheOf(model, appearance, settings);
    if (const auto bytes = cached.find())
        if (auto pictures = picturesOf(*bytes, settings))
            return std::move(*pictures);
    ImpostorPictures pictures = paintImpostor(model, appearance, settings);
    cached.store(bytesOf(pictures));
    return pictures;
}

} // namespace osgTreeWind
