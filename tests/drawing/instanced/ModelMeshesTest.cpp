// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelResources.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/MemoryEstimate.h>

#include <gtest/gtest.h>
#include <osg/Texture2D>

using namespace osgTreeWind;

namespace {

std::uint64_t arrayBytes(const osg::Geometry& geometry) {
    osg::Geometry::ArrayList arrays;
    geometry.getArrayList(arrays);
    std::uint64_t bytes = geometry.getPrimitiveSet(0)->getTotalDataSize();
    for (const osg::ref_ptr<osg::Array>& array : arrays)
        bytes += array->getTotalDataSize();
    return bytes;
}

std::uint64_t recordBytes(const ModelMeshes& meshes) {
    const auto& records = dynamic_cast<const osg::Texture2D&>(
        *meshes.state->getTextureAttribute(15, osg::StateAttribute::TEXTURE));
    EXPECT_EQ(records.getImage(), nullptr) << "OpenGL has it";
    return std::uint64_t(records.getTextureWidth()) * records.getTextureHeight() * sizeof(osg::Vec4);
}

} // namespace

TEST(ModelMeshesTest, EstimateOfMemoryFollowsTheArrays) {
    for (const char* name : {"oak", "Norway spruce", "Scots pine"}) {
        const Species species = *findSpecies(name);
        const auto model = sharedTreeModel(species.tree);
        const ModelMeshes meshes(model, species.appearance);
        const std::uint64_t bytes =
            arrayBytes(*meshes.bark.geometry) + arrayBytes(*meshes.leaves.geometry) + recordBytes(meshes);
        const auto estimate = static_cast<double>(meshBytes(countTree(*model)));
        EXPECT_GT(estimate, 0.9 * static_cast<double>(bytes)) << name;
        EXPECT_LT(estimate, 1.8 * static_cast<double>(bytes)) << name;
    }
}

TEST(ModelMeshesTest, LeavesOfTheFullTierTakeAFractionOfTheirCorners) {
    const Species oak = *findSpecies("oak");
    const auto model = sharedTreeModel(oak.tree);
    const TreeCounts counts = countTree(*model);
    const ModelMeshes meshes(model, oak.appearance);
    EXPECT_LT(recordBytes(meshes), counts.leafVertices * 92 / 4);
    EXPECT_EQ(meshes.leaves.geometry->getVertexArray(), nullptr);
}
