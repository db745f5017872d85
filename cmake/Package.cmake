# SPDX-License-Identifier: Apache-2.0
# `cpack -G DEB` in the build folder makes Debian packages: the program with its man pages, completions and scenes; the
# libraries; the package for Python.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME poinsot)
set(POINSOT_CONTACT "poinsot maintainers <poinsot@localhost>" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGE_CONTACT ${POINSOT_CONTACT})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
list(TRANSFORM POINSOT_EVERY_LAYER PREPEND poinsot_ OUTPUT_VARIABLE libraries)
add_custom_target(poinsot_packed DEPENDS poinsot poinsot_share ${libraries})  # everything in the packages
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME poinsot)
set(CPACK_DEBIAN_PROGRAM_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"From a few lines of text it makes films and pictures of free and driven
rotation, with angular momentum, angular velocity and Poinsot's ellipsoid
rolling on the invariable plane. It needs no screen and no graphics card, and
prints the motion as numbers, too.")
# dpkg-shlibdeps finds the packages of linked libraries, with which the program compares pictures and computes motions.
# Libraries for drawing and films are opened at run time, so they are recommended only: OpenGL, by one of two packages,
# and FFmpeg. Debian names FFmpeg's packages by interface version, which the program takes from the headers
# (src/output/ffmpeg_library.cpp).
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(opened "libosmesa6 | libegl1" libgl1-mesa-dri libimagequant0)
foreach(library libavformat libavcodec libavutil libswscale)
  string(REGEX MATCH "^[0-9]+" major "${LIBAV_${library}_VERSION}")
  list(APPEND opened ${library}${major})
endforeach()
list(JOIN opened ", " CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS)

# poinsot_debian_needs(RESULT LAYER...): sets RESULT to the packages needed to build a program with these layers.
function(poinsot_debian_needs result)
  foreach(layer ${ARGN})
    get_property(links GLOBAL PROPERTY POINSOT_LINKS_${layer})
    foreach(link ${links})
      get_property(package GLOBAL PROPERTY "POINSOT_DEBIAN_${link}")
      list(APPEND packages ${package})
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  set(${result} ${packages} PARENT_SCOPE)
endfunction()

# The package depends on the few packages of the physics. It recommends those for pictures, also the ones opened at
# run time.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpoinsot-dev)
set(CPACK_DEBIAN_DEVELOPMENT_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
poinsot_debian_needs(needed core physics)
poinsot_debian_needs(recommended ${POINSOT_EVERY_LAYER})
list(REMOVE_ITEM recommended ${needed})
list(APPEND recommended ${opened})
list(JOIN needed ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
list(JOIN recommended ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "g++, cmake, pkg-config, poinsot (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"The layers of poinsot as static libraries for C++20: the exact motion of
rotating rigid bodies alone, which needs none of the recommended packages, or
all from the text of a scene to pictures and films.")
install(FILES packaging/copyright DESTINATION share/doc/libpoinsot-dev COMPONENT development)

if(POINSOT_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  add_dependencies(poinsot_packed poinsot_python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-poinsot)
  set(CPACK_DEBIAN_PYTHON_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # An extension module fits one minor version of Python. The package poinsot is needed for films.
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), "
    "python3-numpy, poinsot (= ${PROJECT_VERSION})")
  # Packages that only single functions and the examples import.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-scipy, python3-pil, python3-matplotlib, jupyter-notebook")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"For Python: the exact motion of rotating rigid bodies as numpy arrays, their
pictures and films, also in notebooks.")
  install(FILES packaging/copyright DESTINATION share/doc/python3-poinsot COMPONENT python)
endif()

# Debian requires the changelog of a package in its own format.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/debian/changelog @ONLY CONTENT
"poinsot (@PROJECT_VERSION@) unstable; urgency=medium

  * The changes are listed in CHANGELOG.md of the sources.

 -- @POINSOT_CONTACT@  @now@
")
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/poinsot COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/libpoinsot-dev COMPONENT development)
if(POINSOT_PYTHON)
  install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/python3-poinsot COMPONENT python)
endif()

include(CPack)
