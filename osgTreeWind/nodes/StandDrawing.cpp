// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/StandDrawing.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/ModalLean.h>

namespace osgTreeWind {

StandDrawing::StandDrawing(const PlacedForest& forest)
    : shapes(forest.models().size()), state(new osg::StateSet), fading(new osg::StateSet),
      programs(new PosePrograms) {
    SpeciesStyles styles;
    for (const Species& species : forest.description().species)
        looks.push_back(styles.looks(species));
    fading->setDefine("FADING");
    state->addUniform(new osg::Uniform("leanPower", leanPower));
    state->addUniform(new osg::Uniform("poseRotations", static_cast<int>(PosePass::rotationsUnit)));
    state->addUniform(new osg::Uniform("poseTranslations", static_cast<int>(PosePass::translationsUnit)));
    if (shapes.empty()) // nor a pool of threads
        return;
    impostorProgram = createProgram("impostor", "impostor");
    ThreadPool::executor()(shapes.size(), [&](std::size_t model) {
        const std::size_t species = forest.speciesOfModel(model);
        shapes[model] =
            new StandShape(forest.models()[model], species, forest.description().species[species].appearance,
                           forest.description().drawing, impostorProgram);
    });
}

void StandDrawing::resizeGLObjectBuffers(unsigned maxSize) const {
    for (const osg::ref_ptr<StandShape>& shape : shapes)
        shape->resizeGLObjectBuffers(maxSize);
    for (const SpeciesLooks& look : looks)
        for (const osg::ref_ptr<osg::StateSet>& set : {look.bark, look.leaves, look.ownBark, look.ownLeaves})
            if (set)
                set->resizeGLObjectBuffers(maxSize);
    if (programs) {
        programs->turns->resizeGLObjectBuffers(maxSize);
        programs->poses->resizeGLObjectBuffers(maxSize);
    }
}

void StandDrawing::releaseGLObjects(osg::State* of) const {
    for (const osg::ref_ptr<StandShape>& shape : shapes)
        shape->releaseGLObjects(of);
    for (const SpeciesLooks& look : looks)
        for (const osg::ref_ptr<osg::StateSet>& set : {look.bark, look.leaves, look.ownBark, look.ownLeaves})
            if (set)
                set->releaseGLObjects(of);
    if (programs) {
        programs->turns->releaseGLObjects(of);
        programs->poses->releaseGLObjects(of);
    }
}

} // namespace osgTreeWind
