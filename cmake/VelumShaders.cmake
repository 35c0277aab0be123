# velum_embed_shaders(<output.cpp>): writes every file under shaders/ into one C++ table (path, text), so that
# the programs need no files beside them. Rerun by the build whenever a shader changes.
function(velum_embed_shaders output)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/shaders" "${PROJECT_SOURCE_DIR}/shaders/*")
  list(SORT files)
  list(TRANSFORM files PREPEND "${PROJECT_SOURCE_DIR}/shaders/" OUTPUT_VARIABLE paths)
  string(REPLACE ";" "|" joined "${files}")
  add_custom_command(OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}/shaders" "-DFILES=${joined}" "-DOUTPUT=${output}"
            -P "${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake"
    DEPENDS ${paths} "${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake" VERBATIM)
endfunction()
