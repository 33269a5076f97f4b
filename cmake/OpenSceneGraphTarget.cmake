# SPDX-License-Identifier: MIT
# Defines OpenSceneGraph::OpenSceneGraph, and OpenSceneGraph::osgViewer if it was found, from the variables of CMake's
# modules, which define no targets. Used by the project and by its installed package.
if(NOT TARGET OpenSceneGraph::OpenSceneGraph)
    add_library(OpenSceneGraph::OpenSceneGraph INTERFACE IMPORTED GLOBAL)
    set_target_properties(OpenSceneGraph::OpenSceneGraph PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${OPENSCENEGRAPH_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${OPENSCENEGRAPH_LIBRARIES}")
endif()
if(OSGVIEWER_LIBRARIES AND NOT TARGET OpenSceneGraph::osgViewer)
    add_library(OpenSceneGraph::osgViewer INTERFACE IMPORTED GLOBAL)
    set_target_properties(OpenSceneGraph::osgViewer PROPERTIES INTERFACE_LINK_LIBRARIES "${OSGVIEWER_LIBRARIES}")
endif()
