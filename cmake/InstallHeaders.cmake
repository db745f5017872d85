# SPDX-License-Identifier: Apache-2.0
# Installs POINSOT_HEADERS and all headers of poinsot that they include, from POINSOT_SOURCES to POINSOT_DESTINATION.
# `cmake --install` runs this script, so that it reads the includes from the current sources.
cmake_policy(VERSION 3.25)
set(waiting ${POINSOT_HEADERS})
set(done "")
while(waiting)
  list(POP_FRONT waiting header)
  if(header IN_LIST done)
    continue()
  endif()
  list(APPEND done ${header})
  file(STRINGS ${POINSOT_SOURCES}/${header} includes REGEX "^#include \"")
  list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
  list(APPEND waiting ${includes})
  cmake_path(GET header PARENT_PATH layer)
  file(INSTALL DESTINATION ${POINSOT_DESTINATION}/${layer} TYPE FILE FILES ${POINSOT_SOURCES}/${header})
endwhile()
