// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <cstring>
#include <utility>

namespace osgTreeWind {
namespace {

// Unit 0 holds the texture of bark or leaves; units 1 to 11 are those of the host.
constexpr unsigned unitPosesTextureUnit = 12;
constexpr unsigned leafAnglesTextureUnit = 13;

} // namespace

BranchwiseTrees::BranchwiseTrees(std::shared_ptr<ForestSimulation> simulation)
    : _simulation(std::move(simulation)),
      _unitPoses("unit poses", 2 * movingForest(*_simulation).placed().units),
      _leafAngles("leaf angles", movingForest(*_simulation).placed().leaves) {
    const PlacedForest& forest = movingForest(*_simulation).placed();
    const std::vector<Species>& species = _simulation->description().species;
    for (const Species& each : species)
        _styles.push_back(makeTreeStyle(each.appearance));
    for (std::size_t i = 0; i < forest.models().size(); ++i)
        _buffers.push_back(
            new TreeBuffers(forest.models()[i], species[forest.speciesOfModel(i)].appearance.leafForm));

    setName("trees");
    setDataVariance(osg::Object::DYNAMIC);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        const PlacedTree& tree = forest.trees[i];
        osg::ref_ptr<TreeNode> node = new TreeNode(_buffers[tree.model], _styles[tree.species], tree.scale);
        node->setPosition(toOsg(tree.position));
        node->setAttitude(aboutVertical(tree.heading));
        node->setTexels(static_cast<int>(tree.firstUnit), static_cast<int>(tree.firstLeaf));
        node->setTreeRandom(Random(tree.seed).uniform());
        node->getPosedTree()->setMotion(_simulation, movingForest(*_simulation).motion(i));
        addChild(node);
        _nodes.push_back(node);
    }
    showSeason();

    osg::StateSet* state = getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    clipByAllPlanes(*state);
    bindDataTexture(*state, "unitPoses", unitPosesTextureUnit, _unitPoses.texture());
    useLeafAngles(nullptr);
    uploadUnitPoses();
    uploadLeafAngles();
}

void BranchwiseTrees::showSeason() {
    const std::vector<Species>& species = _simulation->description().species;
    const float season = _simulation->season();
    for (std::size_t i = 0; i < species.size(); ++i)
        _styles[i].showSeason(species[i].appearance, season);
    for (std::size_t i = 0; i < _nodes.size(); ++i) {
        const PlacedTree& tree = movingForest(*_simulation).trees()[i];
        _nodes[i]->setLeafShare(tree.leaves);
        _nodes[i]->setBillboard(_billboards.makeDrawable(tree, *_nodes[i]->getPosedTree(),
                                                         species[tree.species].appearance, season));
    }
}

void BranchwiseTrees::useLeafAngles(osg::Texture2D* texture) {
    bindDataTexture(*getStateSet(), "leafAngles", leafAnglesTextureUnit,
                    texture ? texture : _leafAngles.texture());
}

void BranchwiseTrees::uploadLeafAngles() {
    _leafAngles.fill(movingForest(*_simulation).branches()->leafStates());
}

void BranchwiseTrees::uploadUnitPoses() {
    float* texel = _unitPoses.data();
    for (std::size_t tree = 0; tree < _nodes.size(); ++tree)
        for (const UnitPose& pose : movingForest(*_simulation).motion(tree).poses) {
            const float values[8] = {
                pose.rotation.x,    pose.rotation.y,    pose.rotation.z,    pose.rotation.w,
                pose.translation.x, pose.translation.y, pose.translation.z, 0.0f};
            std::memcpy(texel, values, sizeof values);
            texel += 8;
        }
    _unitPoses.dirty();
}

void BranchwiseTrees::updatePoses(bool moved) {
    if (moved)
        uploadUnitPoses();
    for (const osg::ref_ptr<TreeNode>& node : _nodes)
        node->updatePose(moved);
}

void BranchwiseTrees::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Group::resizeGLObjectBuffers(maxSize);
    for (const osg::ref_ptr<TreeBuffers>& buffers : _buffers)
        buffers->resizeGLObjectBuffers(maxSize);
    _billboards.resizeGLObjectBuffers(maxSize);
}

void BranchwiseTrees::releaseGLObjects(osg::State* state) const {
    osg::Group::releaseGLObjects(state);
    for (const osg::ref_ptr<TreeBuffers>& buffers : _buffers)
        buffers->releaseGLObjects(state);
    for (const TreeStyle& style : _styles)
        style.releaseGLObjects(state);
    _billboards.releaseGLObjects(state);
}

} // namespace osgTreeWind
