# SPDX-License-Identifier: Apache-2.0
# Run by `cmake --install`, with POINSOT_SOURCES, POINSOT_HEADERS and POINSOT_DESTINATION: installs the headers and all
# of ours that they include. At that time, so that the list of includes is that of the sources and kept nowhere.
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
