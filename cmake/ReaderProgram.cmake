# SPDX-License-Identifier: MIT
# A program that reads a format for the library in a separate process. The library looks for it in osgTreeWind/, beside
# itself. Usage: add_reader_program(NAME LIBRARY SOURCE...)     (LIBRARY: the target that reads the format)
function(add_reader_program name library)
    add_executable(${name} ${ARGN} ${PROJECT_SOURCE_DIR}/plugins/ReaderLimits.cpp
                   ${PROJECT_SOURCE_DIR}/osgTreeWind/base/MemoryLimit.cpp
                   ${PROJECT_SOURCE_DIR}/osgTreeWind/base/Unicode.cpp
                   ${osgTreeWind_system_sources})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
    if(WIN32)
        target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/Windows.rc)
    endif()
    target_link_libraries(${name} PRIVATE ${library} glm::glm PkgConfig::utf8proc osgTreeWind_warnings)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY $<TARGET_FILE_DIR:osgTreeWind>/osgTreeWind)
    install(TARGETS ${name} DESTINATION ${module_destination}/osgTreeWind COMPONENT library)
    add_dependencies(osgTreeWind ${name})
endfunction()
