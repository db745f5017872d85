# SPDX-License-Identifier: Apache-2.0
# `cmake --install` runs this before it installs anything. ./poinsot builds the program only, without the man pages,
# completions and the Python package; the file POINSOT_STAMP is there once they are built.
if(NOT EXISTS "${POINSOT_STAMP}" AND NOT CMAKE_INSTALL_COMPONENT STREQUAL "development")
  message(FATAL_ERROR "Man pages and completions are not built yet. Run ./poinsot package, or cmake --build with this "
    "build folder, and then cmake --install again. Nothing was installed.")
endif()
