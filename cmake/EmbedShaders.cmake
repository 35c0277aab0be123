# Script of velum_embed_shaders: ROOT, FILES ('|' between), OUTPUT.
string(REPLACE "|" ";" FILES "${FILES}")
set(text "// Made by cmake/EmbedShaders.cmake.\n#include \"gpu/ShaderFiles.h\"\nnamespace velum::gpu {\nconst ShaderFile kShaderFiles[] = {\n")
foreach(file IN LISTS FILES)
  file(READ "${ROOT}/${file}" content)
  string(APPEND text "{\"${file}\", R\"~~~~(${content})~~~~\"},\n")
endforeach()
string(APPEND text "};\nconst unsigned kShaderFileCount = sizeof(kShaderFiles) / sizeof(kShaderFiles[0]);\n}\n")
file(WRITE "${OUTPUT}" "${text}")
