// SPDX-License-Identifier: MIT
// A forest as a layer of an osgEarth map. Usage: forest-on-globe HEIGHTS IMAGE FILE.treewind [OPTION...]
//   --hours H    time of day, UTC (9)
//   --shadows    osgEarth's ShadowCaster
//   --no-log     linear depth
#include <osgTreeWind/forest/StandOnGround.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/places/FunctionGround.h>

#include <osgEarth/EarthManipulator>
#include <osgEarth/GDAL>
#include <osgEarth/GLUtils>
#include <osgEarth/GeoTransform>
#include <osgEarth/LogarithmicDepthBuffer>
#include <osgEarth/MapNode>
#include <osgEarth/ModelLayer>
#include <osgEarth/Shadowing>
#include <osgEarth/Sky>
#include <osgEarth/TerrainEngineNode>

#include <osgDB/FileUtils>
#include <osgViewer/Viewer>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

using namespace osgEarth;

constexpr double longitude = 8.0, latitude = 48.0; // of the forest's origin, degrees

/// The ground of a map in metres east, north and up of a place.
static std::shared_ptr<osgTreeWind::Ground> groundOf(Map& map, const osg::Matrixd& toGlobe) {
    ElevationPool* elevations = map.getElevationPool();
    const auto heightAt = [elevations, toGlobe, toPlace = osg::Matrixd::inverse(toGlobe)](double x,
                                                                                          double y) {
        const SpatialReference* degrees = SpatialReference::get("wgs84");
        GeoPoint point;
        point.fromWorld(degrees, osg::Vec3d(x, y, 0.0) * toGlobe);
        const ElevationSample sample = elevations->getSample(point, Distance(1.0, Units::METERS), nullptr);
        if (!sample.hasData())
            return std::numeric_limits<double>::quiet_NaN();
        point.z() = sample.elevation().as(Units::METERS);
        osg::Vec3d onGlobe;
        point.toWorld(onGlobe);
        return (onGlobe * toPlace).z(); // falls with the Earth's curve
    };
    return std::make_shared<osgTreeWind::FunctionGround>(heightAt);
}

/// The forest of a file on the ground; null if the file has errors.
static osg::ref_ptr<osgTreeWind::Forest> readTrees(const std::string& file,
                                                   std::shared_ptr<osgTreeWind::Ground> ground) {
    auto description = osgTreeWind::readForestFile(file);
    if (!description) {
        std::cerr << osgTreeWind::toString(description.problems());
        return nullptr;
    }
    osgTreeWind::ForestDescription& trees = description.value();
    trees.ground = std::move(ground);
    std::vector<std::size_t> all(trees.trees.size());
    std::iota(all.begin(), all.end(), 0);
    std::cerr << osgTreeWind::toString(osgTreeWind::standOnGround(trees, all)); // trees without ground
    return new osgTreeWind::Forest(trees);
}

/// Lights trees as osgEarth's sky lights the terrain: less in a low sun, and not at all at night. Call it
/// again if the time of the sky changes. @param up of the place on the globe.
static void lightTrees(osg::StateSet& trees, const osg::Light& sun, const osg::Vec3f& up) {
    osg::Vec3f toSun(sun.getPosition().x(), sun.getPosition().y(), sun.getPosition().z());
    toSun.normalize();
    const float day = std::max(0.0f, toSun * up);
    trees.getOrCreateUniform("osg_LightSource[0].diffuse", osg::Uniform::FLOAT_VEC4)
        ->set(sun.getDiffuse() * day);
    trees.getOrCreateUniform("osg_LightSource[0].ambient", osg::Uniform::FLOAT_VEC4)
        ->set(sun.getAmbient() + sun.getDiffuse() * (0.3f * day));
    trees.setDefine("FILM", "2.2"); // exposure
}

/// A parent for a map, on which the layers of the map cast shadows.
static osg::ref_ptr<osg::Group> shadowsOn(MapNode& map, osg::Light* sun) {
    osg::ref_ptr<Util::ShadowCaster> shadows = new Util::ShadowCaster;
    int unit = 0;
    if (!map.getTerrainEngine()->getResources()->reserveTextureImageUnit(unit, "shadows"))
        return new osg::Group;
    shadows->setTextureImageUnit(unit);
    shadows->setLight(sun);
    shadows->setRanges({0.0f, 200.0f, 1000.0f}); // metres from the eye
    shadows->getShadowCastingGroup()->addChild(map.getLayerNodeGroup());
    return shadows;
}

int main(int argc, char** argv) {
    osg::ArgumentParser arguments(&argc, argv);
    osgEarth::initialize(arguments);
    double hours = 9.0;
    arguments.read("--hours", hours);
    const bool withShadows = arguments.read("--shadows"), isLinear = arguments.read("--no-log");
    if (argc < 4)
        return 1;

    osg::ref_ptr<GDALElevationLayer> heights = new GDALElevationLayer;
    heights->setURL(URI(argv[1]));
    osg::ref_ptr<GDALImageLayer> image = new GDALImageLayer;
    image->setURL(URI(argv[2]));
    osg::ref_ptr<Map> map = new Map;
    map->addLayer(heights);
    map->addLayer(image);
    osg::ref_ptr<MapNode> mapNode = new MapNode(map);
    if (!mapNode->open())
        return 1;

    osgViewer::Viewer viewer(arguments);
    viewer.setUpViewInWindow(0, 0, 960, 540);
    viewer.setRealizeOperation(new GL3RealizeOperation);
    GLUtils::setGlobalDefaults(viewer.getCamera()->getOrCreateStateSet());
    if (isLinear) {
        viewer.getCamera()->setNearFarRatio(1e-5);
    } else {
        Util::LogarithmicDepthBuffer().install(viewer.getCamera());
        osgDB::getDataFilePathList().push_front(SURFACE_FOLDER); // trees write the same depth
    }

    osg::ref_ptr<GeoTransform> place = new GeoTransform; // x east, y north, z up
    place->setPosition(GeoPoint(SpatialReference::get("wgs84"), longitude, latitude, 0.0, ALTMODE_ABSOLUTE));
    osg::ref_ptr<osgTreeWind::Forest> forest = readTrees(argv[3], groundOf(*map, place->getMatrix()));
    if (!forest)
        return 1;
    place->addChild(forest);
    osg::ref_ptr<ModelLayer> trees = new ModelLayer;
    trees->setName("trees");
    trees->setNode(place);
    map->addLayer(trees);

    SkyOptions light;
    light.ambient() = 0.033f; // white if it is not set
    osg::ref_ptr<SkyNode> sky = SkyNode::create(light);
    if (!sky)
        return 1; // no plugin; osgEarth has said so
    sky->setDateTime(DateTime(2024, 6, 21, hours));
    sky->attach(&viewer);
    lightTrees(*trees->getOrCreateStateSet(), *sky->getSunLight(),
               osg::Matrixd::transform3x3(osg::Vec3f(osg::Z_AXIS), place->getMatrix()));
    osg::ref_ptr<osg::Group> scene = sky;
    if (withShadows) {
        scene = shadowsOn(*mapNode, sky->getSunLight());
        sky->addChild(scene);
    }
    scene->addChild(mapNode);

    const osg::Vec3d centre = forest->getBound().center();
    osg::ref_ptr<Util::EarthManipulator> mouse = new Util::EarthManipulator;
    mouse->setHomeViewpoint(Viewpoint("forest", longitude, latitude, centre.z(), -15.0, -7.0, 125.0));
    viewer.setCameraManipulator(mouse);
    viewer.setSceneData(sky);
    std::quick_exit(viewer.run()); // at exit(), OSG 3.6.5 crashes with the plugins of osgEarth
}
