# SPDX-License-Identifier: Apache-2.0
# `cmake --install` runs this script before it installs anything. ./poinsot builds only the program, without man pages,
# completions and the Python package. The file POINSOT_STAMP exists once man pages and completions are built.
if(NOT EXISTS "${POINSOT_STAMP}" AND NOT CMAKE_INSTALL_COMPONENT STREQUAL "development")
  message(FATAL_ERROR "Man pages and completions are not built yet. Run ./poinsot package, or cmake --build with this "
    "build folder, and then cmake --install again. Nothing was installed.")
endif()
