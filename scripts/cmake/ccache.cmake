# SPDX-License-Identifier: Apache-2.0
# Uses ccache and mold if they are found; neither is required.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  if(ROBOCHART_PRECOMPILED)  # without this, ccache recompiles every source that uses a precompiled header
    set(ccache_sloppiness CCACHE_SLOPPINESS=pch_defines,time_macros)
  endif()
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      ${ccache_sloppiness} ${CCACHE_PROGRAM})
endif()
find_program(MOLD_PROGRAM mold)
# mold keeps references to C library functions that only removed code uses, so a package would need a newer C library.
if(MOLD_PROGRAM AND NOT ROBOCHART_SANITIZE AND NOT ROBOCHART_PORTABLE)
  add_link_options(-fuse-ld=mold)
endif()
