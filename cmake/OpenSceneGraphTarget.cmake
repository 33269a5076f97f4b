# SPDX-License-Identifier: MIT
# CMake's module for OpenSceneGraph sets variables only. Defines OpenSceneGraph::OpenSceneGraph from them, for
# the project and for those who use its installed package.
if(NOT TARGET OpenSceneGraph::OpenSceneGraph)
    add_library(OpenSceneGraph::OpenSceneGraph INTERFACE IMPORTED GLOBAL)
    set_target_properties(OpenSceneGraph::OpenSceneGraph PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${OPENSCENEGRAPH_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${OPENSCENEGRAPH_LIBRARIES}")
endif()
