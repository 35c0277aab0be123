# velum_module(<name> SOURCES ... HEADERS ... DEPENDS ... [PRIVATE ...])
# One library per module: target velum_<name>, alias velum::<name>.
# HEADERS are relative to include/velum/<name>; SOURCES to src/<name>.
function(velum_module name)
  cmake_parse_arguments(M "" "" "SOURCES;HEADERS;DEPENDS;PRIVATE" ${ARGN})
  list(TRANSFORM M_HEADERS PREPEND "${PROJECT_SOURCE_DIR}/include/velum/${name}/")
  add_library(velum_${name} STATIC ${M_SOURCES})
  add_library(velum::${name} ALIAS velum_${name})
  set_target_properties(velum_${name} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(velum_${name} PUBLIC FILE_SET HEADERS
    BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${M_HEADERS})
  target_include_directories(velum_${name} PRIVATE "${PROJECT_SOURCE_DIR}/shaders" "${CMAKE_CURRENT_SOURCE_DIR}")
  list(TRANSFORM M_DEPENDS PREPEND "velum::")
  target_link_libraries(velum_${name} PUBLIC ${M_DEPENDS} PRIVATE ${M_PRIVATE} velum_warnings)
  target_compile_features(velum_${name} PUBLIC cxx_std_20)
endfunction()
