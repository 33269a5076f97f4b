// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/Forest.h>

#include <osgTreeWind/gpu/DataTexture.h>

#include <osg/NodeVisitor>

#include <algorithm>
#include <cstring>

namespace osgTreeWind {
namespace {

// Unit 0 is for the textures of bark and leaves.
constexpr unsigned unitPosesTextureUnit = 1;
constexpr unsigned leafAnglesTextureUnit = 2;

void bind(osg::StateSet& state, const char* sampler, unsigned unit, const DataTexture& data) {
    state.setTextureAttribute(unit, data.texture());
    state.getOrCreateUniform(sampler, osg::Uniform::SAMPLER_2D)->set(static_cast<int>(unit));
}

} // namespace

Forest::Forest() : Forest(ForestDescription()) {}

Forest::Forest(ForestDescription description) {
    setNumChildrenRequiringUpdateTraversal(1);
    setDescription(std::move(description));
}

Forest::Forest(const Forest& other, const osg::CopyOp& copyop)
    : osg::Group(other, copyop), _poseMode(other._poseMode) {
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    setStateSet(nullptr);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (std::find(other._trees.begin(), other._trees.end(), other.getChild(i)) != other._trees.end())
            removeChild(i);
    setDescription(other.getDescription());
    setWind(other.getWind());
}

Forest::~Forest() = default;

void Forest::removeTrees() {
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        removeChild(tree);
    _trees.clear();
}

void Forest::setDescription(ForestDescription description) {
    removeTrees();
    _simulation = std::make_shared<ForestSimulation>(std::move(description));
    const ForestSimulation& simulation = *_simulation;

    const TreeStyles styles;
    std::vector<TreeStyle> speciesStyles;
    for (const Species& species : simulation.description().species)
        speciesStyles.push_back(styles.style(species.appearance));
    std::vector<osg::ref_ptr<TreeShape>> shapes;
    for (const TreeModel& model : simulation.models())
        shapes.push_back(new TreeShape(std::shared_ptr<const TreeModel>(_simulation, &model)));

    for (const ForestSimulation::Tree& tree : simulation.trees()) {
        osg::ref_ptr<TreeNode> node =
            new TreeNode(shapes[tree.model], speciesStyles[tree.species], tree.scale);
        node->setPosition(toOsg(tree.position));
        node->setAttitude(osg::Quat(tree.heading, osg::Z_AXIS));
        node->setTexels(static_cast<int>(tree.firstUnit), static_cast<int>(tree.firstLeaf));
        node->getPosedTree()->follow(_simulation, &simulation.poses()[tree.firstUnit],
                                     &simulation.rotations()[tree.firstUnit],
                                     simulation.leafStates().data() + tree.firstLeaf);
        node->setBranchwise(_poseMode == SCENE_GRAPH_POSE);
        insertChild(static_cast<unsigned>(_trees.size()), node);
        _trees.push_back(node);
    }

    _unitPoses = std::make_unique<DataTexture>("unit poses", 2 * simulation.poses().size());
    _leafAngles = std::make_unique<DataTexture>("leaf angles", simulation.leafStates().size());
    osg::StateSet* state = getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    bind(*state, "unitPoses", unitPosesTextureUnit, *_unitPoses);
    bind(*state, "leafAngles", leafAnglesTextureUnit, *_leafAngles);
    uploadPoses();
}

void Forest::setPoseMode(PoseMode mode) {
    _poseMode = mode;
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->setBranchwise(mode == SCENE_GRAPH_POSE);
}

osg::Vec3d Forest::getOrigin() const {
    const glm::dvec3& origin = getDescription().origin;
    return {origin.x, origin.y, origin.z};
}

void Forest::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR && visitor.getFrameStamp())
        update(*visitor.getFrameStamp());
    osg::Group::traverse(visitor);
}

void Forest::update(const osg::FrameStamp& stamp) {
    if (stamp.getFrameNumber() == _lastFrame)
        return;
    _lastFrame = stamp.getFrameNumber();
    if (!_simulation->advance(stamp.getSimulationTime()))
        return;
    uploadPoses();
    for (const osg::ref_ptr<TreeNode>& tree : _trees)
        tree->updatePose();
}

void Forest::uploadPoses() {
    float* texel = _unitPoses->data();
    for (const UnitPose& pose : _simulation->poses()) {
        const float values[8] = {pose.rotation.x,    pose.rotation.y,    pose.rotation.z,    pose.rotation.w,
                                 pose.translation.x, pose.translation.y, pose.translation.z, 0.0f};
        std::memcpy(texel, values, sizeof values);
        texel += 8;
    }
    _unitPoses->dirty();
    const std::vector<glm::vec4>& leaves = _simulation->leafStates();
    if (!leaves.empty())
        std::memcpy(_leafAngles->data(), leaves.data(), leaves.size() * sizeof(glm::vec4));
    _leafAngles->dirty();
}

} // namespace osgTreeWind
