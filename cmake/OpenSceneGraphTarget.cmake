# SPDX-License-Identifier: MIT
# Defines OpenSceneGraph::OpenSceneGraph from the variables of CMake's module, which defines no target. Used by the project
# and by its installed package.
if(NOT TARGET OpenSceneGraph::OpenSceneGraph)
    add_library(OpenSceneGraph::OpenSceneGraph INTERFACE IMPORTED GLOBAL)
    set_target_properties(OpenSceneGraph::OpenSceneGraph PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${OPENSCENEGRAPH_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${OPENSCENEGRAPH_LIBRARIES}")
endif()
