# velum_warnings: the warnings that every target of ours is built with, and the sanitizers when asked for.
add_library(velum_warnings INTERFACE)
# Of sources that are compiled together, names of one are no concern of the next.
if(CMAKE_UNITY_BUILD)
  set(shadow -Wshadow=local -Wno-subobject-linkage)
else()
  set(shadow -Wshadow)
endif()
target_compile_options(velum_warnings INTERFACE -Wall -Wextra ${shadow} -Wnon-virtual-dtor -Wno-missing-field-initializers
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${VELUM_WERROR}>:-Werror>)
if(VELUM_ASAN)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=address,undefined)
endif()
if(VELUM_TSAN)
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
endif()
# Texts that shaders share rely on sums that come out alike wherever they are written (shaders/shared/sheet.h). Plain
# x86-64 has no fused operations to contract them to.
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_options(-ffp-contract=off)
endif()
