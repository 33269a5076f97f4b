# SPDX-License-Identifier: MIT
# Installs the library, headers, data and documentation, and the package for find_package(osgTreeWind).
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/osgTreeWind)
set(data_folder ${CMAKE_INSTALL_DATADIR}/osgTreeWind)

# Relative RPATHs keep the installed files relocatable.
file(RELATIVE_PATH libraries_from_programs ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
foreach(program osgtreewind osgtreewind-egl)
    if(TARGET ${program})
        set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_programs}")
    endif()
endforeach()
set_target_properties(osgdb_treewind osgdb_serializers_osgtreewind PROPERTIES INSTALL_RPATH "$ORIGIN/..")

function(install_export target export)
    install(TARGETS ${target} EXPORT ${export} ${ARGN}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
    install(EXPORT ${export} NAMESPACE osgTreeWind:: DESTINATION ${package_folder} COMPONENT development)
endfunction()
install_export(osgTreeWind osgTreeWindTargets FILE_SET HEADERS COMPONENT development)
foreach(backend OSMesa EGL WGL)
    if(TARGET osgTreeWind::${backend})
        install_export(osgTreeWind${backend} osgTreeWind${backend}Targets)
    endif()
endforeach()
if(TARGET osgTreeWindHeadless)
    install(TARGETS osgTreeWindHeadless LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/osgTreeWind COMPONENT tool)
endif()

install(DIRECTORY shaders DESTINATION ${data_folder} COMPONENT development
    PATTERN CMakeLists.txt EXCLUDE)
install(FILES osgTreeWind/species/species.treewind DESTINATION ${data_folder} COMPONENT development)
install(FILES examples/thesis.treewind examples/forest.treewind examples/helicopter.treewind examples/lorry.treewind examples/explosion.treewind DESTINATION ${data_folder}/examples
    COMPONENT tool)
find_program(help2man help2man)
if(help2man AND TARGET osgtreewind AND NOT CMAKE_CROSSCOMPILING)
    install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/script/man-pages\" \"$<TARGET_FILE:osgtreewind>\" ${PROJECT_VERSION}
        \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT tool)
endif()
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/osgtreewind-doc COMPONENT documentation)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/osgtreewind-doc COMPONENT documentation)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)

set(pkgconfig_libraries -losgTreeWind)
if(osgTreeWind_linkage STREQUAL "STATIC") # with the plugins and the dependencies of the library
    set(pkgconfig_libraries "-losgdb_treewind -losgdb_serializers_osgtreewind -losgTreeWind")
    set(pkgconfig_static
        "Requires.private: openscenegraph-osgViewer tomlplusplus pugixml zlib sqlite3 libutf8proc\nLibs.private: -lcsv -lOpenGL")
    install(FILES cmake/FindLibCsv.cmake DESTINATION ${package_folder} COMPONENT development)
endif()
file(RELATIVE_PATH prefix_from_pkgconfig ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/osgTreeWind.pc.in osgTreeWind.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/osgTreeWind.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)

configure_package_config_file(cmake/osgTreeWindConfig.cmake.in osgTreeWindConfig.cmake
    INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(osgTreeWindConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/osgTreeWindConfig.cmake ${PROJECT_BINARY_DIR}/osgTreeWindConfigVersion.cmake
    cmake/OpenSceneGraphTarget.cmake cmake/FindOSMesa.cmake DESTINATION ${package_folder} COMPONENT development)
