# velum_module(<name> [BRIEF] [SOURCES ...] [HEADERS ...] DEPENDS ... [PRIVATE ...] [ROOMS ...])
# One shared library per module, so that programs, plug-ins and the programs of others have each of them once: target velum_<name>,
# alias velum::<name>, libvelum-<name>.so. SOURCES and HEADERS are relative to src/<name>. HEADERS are
# those that other modules may include, and no others (.ci/check_layers.py reads the lists). ROOMS are folders in it that call
# velum_room(). An include names its file by the path from src. BRIEF: see velum_brief().
function(velum_module name)
  cmake_parse_arguments(M "BRIEF" "" "SOURCES;HEADERS;DEPENDS;PRIVATE;ROOMS" ${ARGN})
  list(TRANSFORM M_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  add_library(velum_${name} SHARED ${M_SOURCES})
  add_library(velum::${name} ALIAS velum_${name})
  set_target_properties(velum_${name} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON OUTPUT_NAME velum-${name}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
  target_compile_options(velum_${name} PRIVATE ${VELUM_OWN_CALLS})
  target_sources(velum_${name} PUBLIC FILE_SET HEADERS
    BASE_DIRS "${PROJECT_SOURCE_DIR}/src" FILES ${M_HEADERS})
  target_include_directories(velum_${name} PRIVATE "${PROJECT_SOURCE_DIR}/shaders")
  list(TRANSFORM M_DEPENDS PREPEND "velum::")
  target_link_libraries(velum_${name} PUBLIC ${M_DEPENDS} PRIVATE ${M_PRIVATE} velum_warnings)
  target_compile_features(velum_${name} PUBLIC cxx_std_20)
  if(M_BRIEF)
    velum_brief(velum_${name} 2)
  endif()
  velum_precompile(velum_${name} <fmt/format.h>)
  foreach(room IN LISTS M_ROOMS)
    add_subdirectory(${room})
  endforeach()
  install(TARGETS velum_${name} EXPORT Velum LIBRARY COMPONENT library
    FILE_SET HEADERS DESTINATION "${VELUM_HEADERS}" COMPONENT library)
endfunction()

# A library's calls of its own functions are not looked up: they may be inlined as in a program.
set(VELUM_OWN_CALLS -fno-semantic-interposition)
# GCC inlines less in what it takes for a large source, more than 10000 instructions. Several that are compiled together are several:
# without this the loops over all instances of a model took twice as long.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_UNITY_BUILD)
  math(EXPR VELUM_LARGE_SOURCE "10000 * ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
  list(APPEND VELUM_OWN_CALLS --param=large-unit-insns=${VELUM_LARGE_SOURCE})
endif()
# Where headers of the modules are installed: found from include/velum/*.h, and out of the way of everybody else's.
set(VELUM_HEADERS "${CMAKE_INSTALL_INCLUDEDIR}/velum/detail")

# velum_brief(<target> <level>): what users get of the target is optimised less, as nobody waits for its loops: that takes a fifth of
# the compiler's time off (level 2), or half of it (level 1).
function(velum_brief target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# velum_plugin(<module> <name> SOURCES ... PRIVATE ...): sources of the module that link heavy libraries, as libvelum-<module>-<name>.so, which
# the module loads when it is first asked for what is in it. SOURCES are relative to src/<module>. All of them: velum-plugins.
function(velum_plugin module name)
  cmake_parse_arguments(P "" "" "SOURCES;PRIVATE" ${ARGN})
  add_library(velum-${module}-${name} MODULE ${P_SOURCES})
  target_include_directories(velum-${module}-${name} PRIVATE "${PROJECT_SOURCE_DIR}/shaders")
  target_compile_options(velum-${module}-${name} PRIVATE ${VELUM_OWN_CALLS})
  target_link_libraries(velum-${module}-${name} PRIVATE velum_${module} ${P_PRIVATE} velum_warnings)
  set_target_properties(velum-${module}-${name} PROPERTIES INSTALL_RPATH "$ORIGIN/.."
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/velum" UNITY_BUILD OFF)  # minutes each: side by side
  if(NOT TARGET velum-plugins)
    add_custom_target(velum-plugins)
  endif()
  add_dependencies(velum-plugins velum-${module}-${name})
  install(TARGETS velum-${module}-${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/velum" COMPONENT library)
endfunction()

# velum_alone(<name> ...): sources of the folder that it is called in, of the module <name>, that are compiled one by one. All others
# are compiled several together, so that the headers that they share are read once: what is in their anonymous namespaces
# then needs names that differ from their neighbours'. Those named here have names alike by design, as readers do.
function(velum_alone name)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY velum_${name} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# velum_room(<name> [HEADERS ...] [SOURCES ...]): adds the folder that it is called in to the module <name>; HEADERS and SOURCES are
# relative to the folder.
function(velum_room name)
  cmake_parse_arguments(R "" "" "SOURCES;HEADERS" ${ARGN})
  list(TRANSFORM R_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  list(TRANSFORM R_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  target_sources(velum_${name} PRIVATE ${R_SOURCES})
  if(R_HEADERS)
    target_sources(velum_${name} PUBLIC FILE_SET HEADERS FILES ${R_HEADERS})
  endif()
endfunction()
