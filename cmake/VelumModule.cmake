# velum_module(<name> [SOURCES ...] [HEADERS ...] DEPENDS ... [PRIVATE ...] [ROOMS ...])
# One library per module: target velum_<name>, alias velum::<name>. SOURCES and HEADERS are relative to src/<name>. HEADERS are
# those that other modules may include, and no others (.ci/check_layers.py reads the lists). ROOMS are folders in it that call
# velum_room(). An include names its file by the path from src.
function(velum_module name)
  cmake_parse_arguments(M "" "" "SOURCES;HEADERS;DEPENDS;PRIVATE;ROOMS" ${ARGN})
  list(TRANSFORM M_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  add_library(velum_${name} STATIC ${M_SOURCES})
  add_library(velum::${name} ALIAS velum_${name})
  set_target_properties(velum_${name} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(velum_${name} PUBLIC FILE_SET HEADERS
    BASE_DIRS "${PROJECT_SOURCE_DIR}/src" FILES ${M_HEADERS})
  target_include_directories(velum_${name} PRIVATE "${PROJECT_SOURCE_DIR}/shaders")
  list(TRANSFORM M_DEPENDS PREPEND "velum::")
  target_link_libraries(velum_${name} PUBLIC ${M_DEPENDS} PRIVATE ${M_PRIVATE} velum_warnings)
  target_compile_features(velum_${name} PUBLIC cxx_std_20)
  velum_precompile(velum_${name} <fmt/format.h>)
  foreach(room IN LISTS M_ROOMS)
    add_subdirectory(${room})
  endforeach()
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
