// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/drawing/looks/SameImage.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/drawing/impostors/ImpostorCache.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <osgDB/WriteFile>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

using namespace osgTreeWind;

namespace {

namespace files = std::filesystem;

constexpr ImpostorSettings quick{4, 2, 32, 1, 1.0f};

constexpr int otherForm = 3;

/// The textures of the default appearance and of the other forms, so that the cache stores only impostors.
struct HeldTextures {
    HeldTextures() {
        Appearance other;
        other.leafForm = static_cast<LeafForm>(otherForm);
        other.barkForm = static_cast<BarkForm>(otherForm);
        for (const Appearance& appearance : {Appearance(), other})
            for (const osg::ref_ptr<osg::Image>& image : {leafImage(appearance), barkImage(appearance)})
                images.push_back(image);
    }
    std::vector<osg::ref_ptr<osg::Image>> images;
};

const TreeModel& shape() {
    static const TreeModel model = makeTreeModel({});
    return model;
}

bool isEqual(const ImpostorPictures& a, const ImpostorPictures& b) {
    return isSameImage(*a.colors, *b.colors) && isSameImage(*a.normals, *b.normals) &&
           a.azimuths == b.azimuths && a.elevations == b.elevations && a.pixels == b.pixels &&
           a.halfWidth == b.halfWidth && a.height == b.height && a.extents == b.extents;
}

} // namespace

TEST(ImpostorCache, ReadsWhatWasPainted) {
    const TemporaryFolder folder, aside;
    const HeldTextures textures;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    const ImpostorPictures painted = paintImpostor(shape(), {}, quick);
    EXPECT_TRUE(isEqual(cachedImpostor(shape(), {}, quick), painted));
    ASSERT_EQ(folder.countFiles(), 1u);
    const files::path file = files::directory_iterator(folder.path())->path(), link = aside.path() + "/link";
    files::create_hard_link(file, link);
    EXPECT_TRUE(isEqual(cachedImpostor(shape(), {}, quick), painted));
    EXPECT_TRUE(files::equivalent(file, link)) << "storing replaces the file";
}

TEST(ImpostorCache, PaintsDamagedFilesAnew) {
    const TemporaryFolder folder;
    const HeldTextures textures;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    TreeModel other = shape();
    other.leaves.resize(other.leaves.size() / 2);
    const ImpostorPictures painted = cachedImpostor(other, {}, quick);
    const std::string file = files::directory_iterator(folder.path())->path().string(), whole = bytesOf(file);
    for (const double part : {0.0, 0.1, 0.5, 0.99}) {
        const auto size = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
        std::ofstream(file, std::ios::binary) << whole.substr(0, size);
        EXPECT_TRUE(isEqual(cachedImpostor(other, {}, quick), painted));
        EXPECT_EQ(bytesOf(file), whole);
        std::string damaged = whole;
        damaged[size] = static_cast<char>(damaged[size] ^ 1);
        std::ofstream(file, std::ios::binary) << damaged;
        EXPECT_TRUE(isEqual(cachedImpostor(other, {}, quick), painted));
        EXPECT_EQ(bytesOf(file), whole);
    }
}

TEST(ImpostorCache, KeyDependsOnAppearanceShapeAndSettings) {
    const TemporaryFolder folder, pictures;
    const HeldTextures textures;
    const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", folder.path().c_str());
    std::size_t entries = 0;
    const auto addsEntry = [&](const TreeModel& model, const Appearance& appearance,
                               const ImpostorSettings& settings) {
        cachedImpostor(model, appearance, settings);
        const std::size_t before = entries;
        entries = folder.countFiles();
        return entries > before;
    };
    EXPECT_TRUE(addsEntry(shape(), {}, quick));
    EXPECT_FALSE(addsEntry(shape(), {}, quick));
    for (const Key& key : keysOf<Appearance>()) {
        Appearance changed;
        const Member member = key.of(&changed);
        if (const auto* color = std::get_if<glm::vec3*>(&member))
            (*color)->y += 0.125f;
        else if (const auto* number = std::get_if<float*>(&member))
            **number += 0.125f;
        else if (const auto* form = std::get_if<EnumMember>(&member))
            form->set(form->object, otherForm);
        else
            continue; // optional values, and files
        EXPECT_TRUE(addsEntry(shape(), changed, quick)) << key.name;
    }
    Appearance oldBark;
    oldBark.oldBark = glm::vec3(0.5f);
    EXPECT_TRUE(addsEntry(shape(), oldBark, quick));
    ImpostorSettings sparse = quick;
    sparse.leaves = 0.5f;
    EXPECT_TRUE(addsEntry(shape(), {}, sparse));
    TreeModel model = shape();
    model.leaves.back().size *= 1.5f;
    EXPECT_TRUE(addsEntry(model, {}, quick)) << "a leaf";
    model.skeleton.points.back().x += 1.0f;
    EXPECT_TRUE(addsEntry(model, {}, quick)) << "a branch";
    model.skeleton.units.back().baseRadius *= 2.0f;
    EXPECT_TRUE(addsEntry(model, {}, quick)) << "a radius";

    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(8, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::memset(picture->data(), 100, picture->getTotalSizeInBytes());
    Appearance own;
    own.leafImage = pictures.path() + "/leaf.png";
    ASSERT_TRUE(osgDB::writeImageFile(*picture, own.leafImage));
    EXPECT_TRUE(addsEntry(shape(), own, quick));
    EXPECT_FALSE(addsEntry(shape(), own, quick));
    own.leafImage = pictures.path() + "/other.png";
    ASSERT_TRUE(osgDB::writeImageFile(*picture, own.leafImage));
    EXPECT_FALSE(addsEntry(shape(), own, quick)) << "a path";
    std::memset(picture->data(), 50, picture->getTotalSizeInBytes() / 2);
    own.leafImage = pictures.path() + "/changed.png";
    ASSERT_TRUE(osgDB::writeImageFile(*picture, own.leafImage));
    EXPECT_TRUE(addsEntry(shape(), own, quick)) << "the bytes of a picture";
}
