# velum_embed_file(<input> <output.cpp> <name>): writes a file's bytes into a C++ array velum::<name>, and their number as
# velum::<name>Size, so that the programs need no files beside them.
function(velum_embed_file input output name)
  add_custom_command(OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} "-DINPUT=${input}" "-DOUTPUT=${output}" "-DNAME=${name}" -P "${PROJECT_SOURCE_DIR}/cmake/EmbedFile.cmake"
    DEPENDS "${input}" "${PROJECT_SOURCE_DIR}/cmake/EmbedFile.cmake" VERBATIM)
endfunction()
