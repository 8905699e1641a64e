# SPDX-License-Identifier: Apache-2.0
# Warnings for all our code. They are errors if ROBOCHART_WERROR is on (the dev preset and CI).
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
if(ROBOCHART_WERROR)
  add_compile_options(-Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports these inside its own standard library at -O2 (GCC bugs 105329, 107852).
  add_compile_options(-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(ROBOCHART_SANITIZE)
  add_compile_options(-fsanitize=${ROBOCHART_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ROBOCHART_SANITIZE})
endif()
