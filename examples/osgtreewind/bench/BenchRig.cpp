// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchRig.h>

#include <examples/osgtreewind/bench/BenchStage.h>
#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/SpeciesLooks.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/PosedPoints.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <osg/Geode>
#include <osg/PositionAttitudeTransform>
#include <osgAnimation/BoneMapVisitor>
#include <osgAnimation/RigGeometry>
#include <osgAnimation/RigTransformHardware>
#include <osgAnimation/RigTransformSoftware>
#include <osgAnimation/Skeleton>
#include <osgAnimation/StackedQuaternionElement>
#include <osgAnimation/StackedTranslateElement>
#include <osgAnimation/UpdateBone>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr std::size_t recordedSteps = 240;

/// Rotations of all units about their bases, step by step.
struct Recording {
    std::vector<std::vector<osg::Quat>> steps;

    explicit Recording(const PlacedForest& forest) {
        ForestDescription one = forest.description();
        one.trees = {forest.placementOf(0)};
        ForestSimulation simulation(one);
        const BenchWinds winds;
        for (std::size_t step = 0; step < recordedSteps; ++step) {
            throwIfAny(simulation.setWind(winds.at(static_cast<int>(step))));
            simulation.advance(static_cast<double>(step) / 60.0);
            std::vector<osg::Quat> turns;
            for (const glm::quat& turn : movingForest(simulation).motion(0).rotations)
                turns.push_back(toOsg(turn));
            steps.push_back(std::move(turns));
        }
    }
};

using Turns = std::vector<osg::ref_ptr<osgAnimation::StackedQuaternionElement>>; // by unit

/// Plays the recording on the bones of a skeleton, before they are updated.
class RecordingPlayer : public osgAnimation::Skeleton::UpdateSkeleton {
public:
    RecordingPlayer(std::shared_ptr<const Recording> recording, Turns turns, std::size_t start)
        : _recording(std::move(recording)), _turns(std::move(turns)), _step(start) {}
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override {
        const std::vector<osg::Quat>& now = _recording->steps[_step++ % _recording->steps.size()];
        for (std::size_t unit = 0; unit < now.size(); ++unit)
            _turns[unit]->setQuaternion(now[unit]);
        osgAnimation::Skeleton::UpdateSkeleton::operator()(node, visitor);
    }

private:
    std::shared_ptr<const Recording> _recording;
    Turns _turns;
    std::size_t _step;
};

/// Rigs share their program, as in OSG's example osganimationhardware.
class SharedProgramHardware : public osgAnimation::RigTransformHardware {
protected:
    bool init(osgAnimation::RigGeometry& rig) override {
        if (_perVertexInfluences.empty()) {
            prepareData(rig);
            return false;
        }
        if (!rig.getSkeleton())
            return false;
        osgAnimation::BoneMapVisitor bones;
        rig.getSkeleton()->accept(bones);
        if (!buildPalette(bones.getBoneMap(), rig))
            return false;
        rig.copyFrom(*rig.getSourceGeometry());
        rig.setVertexAttribArray(getFirstVertexAttributeTarget(), getVertexAttrib(0));
        rig.setStateSet(new osg::StateSet);
        rig.getStateSet()->addUniform(_uniformMatrixPalette);
        _needInit = false;
        return true;
    }
};

std::string boneName(std::size_t unit) {
    return "unit " + std::to_string(unit);
}

/// Vertices in the rest pose. gl_MultiTexCoord0 holds u, v and the shade of the vertex.
class RestGeometry {
public:
    void add(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv, int unit, float shade) {
        _positions->push_back(toOsg(position));
        _normals->push_back(toOsg(normal));
        _coordinates->push_back({uv.x, uv.y, shade});
        auto& bone = (*_influences)[boneName(static_cast<std::size_t>(unit))];
        bone.setName(boneName(static_cast<std::size_t>(unit)));
        bone.emplace_back(static_cast<unsigned>(_positions->size() - 1), 1.0f);
    }
    void setTriangles(const std::vector<unsigned>& indices) {
        _geometry->setVertexArray(_positions);
        _geometry->setNormalArray(_normals, osg::Array::BIND_PER_VERTEX);
        _geometry->setTexCoordArray(0, _coordinates);
        _geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()), indices.data()));
    }
    /// A rig with its own copy of the arrays, so that each tree moves independently.
    osg::ref_ptr<osgAnimation::RigGeometry> rig(bool hardware) const {
        osg::ref_ptr<osgAnimation::RigGeometry> rig = new osgAnimation::RigGeometry;
        rig->setSourceGeometry(osg::clone(_geometry.get(), osg::CopyOp::DEEP_COPY_ALL));
        rig->setInfluenceMap(_influences);
        if (hardware)
            rig->setRigTransformImplementation(new SharedProgramHardware);
        else
            rig->setRigTransformImplementation(new osgAnimation::RigTransformSoftware);
        return rig;
    }

private:
    osg::ref_ptr<osg::Geometry> _geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> _positions = new osg::Vec3Array, _normals = new osg::Vec3Array,
                                 _coordinates = new osg::Vec3Array;
    osg::ref_ptr<osgAnimation::VertexInfluenceMap> _influences = new osgAnimation::VertexInfluenceMap;
};

RestGeometry restBark(const TreeModel& model, const TreeScale& scale) {
    RestGeometry rest;
    for (const SkinVertex& v : model.skin().vertices)
        rest.add(posedSkinPoint(v, scale, {}), v.outward, v.uv, static_cast<int>(v.unit), 1.0f);
    rest.setTriangles({model.skin().indices.begin(), model.skin().indices.end()});
    return rest;
}

RestGeometry restLeaves(const TreeModel& model, const TreeScale& scale) {
    RestGeometry rest;
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(LeafForm::Blade));
    for (std::size_t i = 0; i < model.leaves.size(); ++i) {
        const LeafCluster& leaf = model.leaves[i];
        const glm::vec3 outward = crown.outward(leaf.anchor);
        const float sky = crown.at(leaf.anchor).sky;
        const auto own = static_cast<float>(std::fmod(0.754878 * static_cast<double>(i), 1.0));
        for (std::size_t corner = 0; corner < model.leafMesh.size();
             ++corner) { // light as in shaders/leaf.vert
            const LeafVertex& v = model.leafMesh[corner];
            const glm::vec3 blade = leaf.orientation * v.normal;
            const float side = glm::dot(blade, outward) < 0.0f ? -0.5f : 0.5f;
            rest.add(posedLeafPoint(leaf, v.corner, leaf.orientation, scale, {}),
                     glm::normalize(outward + side * blade), LeafAtlas::sprayCoordinate(i, corner / 4, v.uv),
                     leaf.unit, (0.88f + 0.24f * own) * sky);
        }
    }
    rest.setTriangles(leafIndices(model.leaves.size()));
    return rest;
}

osg::ref_ptr<osg::Program> rigProgram(const std::string& part, bool hardware, std::size_t bones) {
    // Two bones per attribute, as in osgAnimation's skinning.vert.
    const std::string place = hardware
                                  ? "vec4 at = vec4(0.0), bones = boneWeight0;\nvec3 normal = vec3(0.0);\n"
                                    "for (int i = 0; i < 2; ++i, bones = bones.zwxy) {\n"
                                    "mat4 bone = matrixPalette[int(bones.x)];\n"
                                    "at += bones.y * (bone * osg_Vertex);\n"
                                    "normal += bones.y * (mat3(bone) * osg_Normal);\n}\n"
                                  : "vec4 at = osg_Vertex;\nvec3 normal = osg_Normal;\n";
    const std::string palette =
        "uniform mat4 matrixPalette[" + std::to_string(bones) + "];\nlayout(location = " +
        std::to_string(osgAnimation::RigTransformHardware().getFirstVertexAttributeTarget()) +
        ") in vec4 boneWeight0;\n";
    const std::string normal = "normalize(osg_NormalMatrix * normal), ", blade = part == "leaf" ? normal : "";
    const std::string text = shaderText("light.glsl") + (hardware ? palette : "") + "out vec" +
                             (part == "bark" ? "3 " : "2 ") + part + "Coord;\nout vec3 " + part +
                             "Light;\nout vec2 barkGirth, leafFacing;\nout float barkCover;\nvoid main() {\n"
                             "barkGirth = vec2(0.1, 1.0);\nbarkCover = 1.0;\nleafFacing = vec2(1.0, 0.0);\n" +
                             place + "vec4 eyePosition = osg_ModelViewMatrix * at;\n" + part +
                             "Light = osg_MultiTexCoord0.z * " + part + "Shade(eyePosition.xyz, " + normal +
                             blade + "Shade(vec4(1.0), vec4(1.0), vec2(1.0, 0.0), 1.0));\n" + part +
                             "Coord = osg_MultiTexCoord0.xy" + (part == "bark" ? "x" : "") +
                             ";\ngl_Position = osg_ProjectionMatrix * eyePosition;\n}\n";
    return makeProgram(part, text, shaderText(part + ".frag"));
}

/// Makes the bones of a tree. @param turns receives the rotations that move them.
osg::ref_ptr<osgAnimation::Skeleton> skeletonOf(const Skeleton& wood, const TreeScale& scale, Turns& turns) {
    osg::ref_ptr<osgAnimation::Skeleton> skeleton = new osgAnimation::Skeleton;
    std::vector<osg::ref_ptr<osgAnimation::Bone>> bones;
    for (std::size_t unit = 0; unit < wood.units.size(); ++unit) {
        const int parent = wood.units[unit].parent;
        const osg::Vec3 base = toOsg(scale.axes * wood.units[unit].base);
        const osg::Vec3 from =
            parent < 0 ? osg::Vec3() : toOsg(scale.axes * wood.units[static_cast<std::size_t>(parent)].base);
        osg::ref_ptr<osgAnimation::Bone> bone = new osgAnimation::Bone(boneName(unit));
        bone->setInvBindMatrixInSkeletonSpace(osg::Matrix::translate(-base));
        osg::ref_ptr<osgAnimation::UpdateBone> update = new osgAnimation::UpdateBone(boneName(unit));
        turns.push_back(new osgAnimation::StackedQuaternionElement("turn"));
        update->getStackedTransforms().push_back(
            new osgAnimation::StackedTranslateElement("base", base - from));
        update->getStackedTransforms().push_back(turns.back());
        bone->setUpdateCallback(update);
        (parent < 0 ? static_cast<osg::Group*>(skeleton) : bones[static_cast<std::size_t>(parent)])
            ->addChild(bone);
        bones.push_back(bone);
    }
    return skeleton;
}

} // namespace

osg::ref_ptr<osg::Group> createRiggedTrees(const PlacedForest& forest, bool hardware) {
    const TreeModel& model = *forest.models().front();
    const TreeScale scale = forest.trees.front().scale;
    const auto recording = std::make_shared<const Recording>(forest);
    const RestGeometry bark = restBark(model, scale), leaves = restLeaves(model, scale);
    SpeciesLooks looks = makeSpeciesLooks(forest.description().species.front());
    const std::size_t bones = model.skeleton.units.size();
    looks.bark->setAttributeAndModes(rigProgram("bark", hardware, bones));
    looks.leaves->setAttributeAndModes(rigProgram("leaf", hardware, bones));

    osg::ref_ptr<osg::Group> trees = new osg::Group;
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        Turns turns;
        osg::ref_ptr<osgAnimation::Skeleton> skeleton = skeletonOf(model.skeleton, scale, turns);
        skeleton->setUpdateCallback(new RecordingPlayer(recording, std::move(turns), 7 * i));
        for (const auto& [part, state] : {std::pair(&bark, looks.bark), std::pair(&leaves, looks.leaves)}) {
            osg::ref_ptr<osg::Geode> geode = new osg::Geode;
            geode->setStateSet(state);
            geode->addDrawable(part->rig(hardware));
            skeleton->addChild(geode);
        }
        osg::ref_ptr<osg::PositionAttitudeTransform> place = new osg::PositionAttitudeTransform;
        place->setPosition(toOsg(forest.trees[i].position));
        place->addChild(skeleton);
        trees->addChild(place);
    }
    return trees;
}
