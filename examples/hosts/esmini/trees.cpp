// SPDX-License-Identifier: MIT
// Linked into esmini: it reads .treewind files, and its forests get the wind of the scenario.
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <osgDB/Registry>

#include <cmath>

USE_OSGPLUGIN(treewind)

// Asked for by esmini for static OSG. Shared OSG loads its plugins itself.
extern "C" {
void osgdb_osg2() {}
void osgdb_jpeg() {}
void osgdb_png() {}
void wrapper_serializer_library_osg() {}
void wrapper_serializer_library_osgSim() {}
}

/// Sets the wind of all forests of a scene.
class SetWind : public osg::NodeVisitor {
public:
    explicit SetWind(const osgTreeWind::Wind& wind) : NodeVisitor(TRAVERSE_ALL_CHILDREN), _wind(wind) {}
    void apply(osg::Group& node) override {
        if (auto* forest = dynamic_cast<osgTreeWind::Forest*>(&node))
            OSG_WARN << toString(forest->setWind(_wind)); // empty: no problem
        traverse(node);
    }

private:
    osgTreeWind::Wind _wind;
};

/// Sets the Wind of a scenario, with gusts around its speed. @param scene the forests are below it
/// @param direction where it blows to, radians counterclockwise from x @param speed m/s
void setTreeWind(osg::Node& scene, double direction, double speed) {
    osgTreeWind::Wind wind(std::make_shared<osgTreeWind::UniformWind>(
        glm::vec3(speed * std::cos(direction), speed * std::sin(direction), 0.0)));
    wind.gusts.intensity = 0.2;
    SetWind setWind(wind);
    scene.accept(setWind);
}
