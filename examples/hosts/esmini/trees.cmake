# SPDX-License-Identifier: MIT
# Builds esmini with the shared OpenSceneGraph of the system and a static osgTreeWind, without a change of esmini's CMake
# files. run.sh gives it to CMake as CMAKE_PROJECT_INCLUDE.
find_package(OpenSceneGraph 3.6 REQUIRED COMPONENTS osgViewer osgDB osgGA osgText osgSim osgUtil osgAnimation)
find_package(osgTreeWind REQUIRED)
add_library(trees OBJECT ${CMAKE_CURRENT_LIST_DIR}/trees.cpp)
set_target_properties(trees PROPERTIES CXX_STANDARD 17 POSITION_INDEPENDENT_CODE ON)
target_link_libraries(trees PUBLIC
    osgTreeWind::osgdb_treewind osgTreeWind::osgTreeWind ${OPENSCENEGRAPH_LIBRARIES} GL X11)

include(${CMAKE_SOURCE_DIR}/support/cmake/external/osg.cmake) # before esmini, which then keeps the macro below
macro(set_osg_libs)
    set(OSG_LIBRARIES trees)
endmacro()
