# velum_warnings: the warnings that every target of ours is built with, and the sanitizers when asked for.
add_library(velum_warnings INTERFACE)
target_compile_options(velum_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers -Wno-restrict
  $<$<BOOL:${VELUM_WERROR}>:-Werror>)
if(VELUM_ASAN)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=address,undefined)
endif()
