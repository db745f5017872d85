# SPDX-License-Identifier: Apache-2.0
# poinsot_third_party(TARGET PACKAGE name [word ...] [AT_LEAST version] REQUIRES "module >= version" DEBIAN package)
# poinsot_third_party(PkgConfig::PREFIX MODULES module>=version ... DEBIAN package)
#
# Finds a library and records how, because a project that links an installed layer must find the library, too: by CMake
# (PACKAGE) or pkg-config (REQUIRES); MODULES serves both. DEBIAN is the library's Debian package. AT_LEAST is compared
# here, because some packages reject requests for an older version, as Eigen 5 rejects 3.4. This is a macro, because
# find_package() must set variables of its caller.
macro(poinsot_third_party target)
  cmake_parse_arguments(PARTY "" "AT_LEAST;REQUIRES;DEBIAN" "PACKAGE;MODULES" ${ARGN})
  if(DEFINED PARTY_PACKAGE)
    if(NOT PARTY_AT_LEAST)
      set(PARTY_AT_LEAST 0)
    endif()
    find_package(${PARTY_PACKAGE} REQUIRED)
    list(GET PARTY_PACKAGE 0 PARTY_NAME)
    if(${PARTY_NAME}_VERSION VERSION_LESS PARTY_AT_LEAST)
      message(FATAL_ERROR "${PARTY_NAME} ${${PARTY_NAME}_VERSION} is older than ${PARTY_AT_LEAST} (Debian: ${PARTY_DEBIAN})")
    endif()
    list(JOIN PARTY_PACKAGE " " PARTY_WORDS)
    set_property(GLOBAL PROPERTY "POINSOT_FIND_${target}"
      "_poinsot_find_package(${PARTY_DEBIAN} ${PARTY_AT_LEAST} ${PARTY_WORDS})")
  else()
    find_package(PkgConfig REQUIRED)
    string(REPLACE "PkgConfig::" "" PARTY_PREFIX ${target})
    pkg_check_modules(${PARTY_PREFIX} REQUIRED IMPORTED_TARGET GLOBAL ${PARTY_MODULES})
    list(JOIN PARTY_MODULES " " PARTY_WORDS)
    set_property(GLOBAL PROPERTY "POINSOT_FIND_${target}"
      "_poinsot_find_modules(${PARTY_DEBIAN} ${PARTY_PREFIX} ${PARTY_WORDS})")
    list(JOIN PARTY_MODULES ", " PARTY_REQUIRES)
    string(REPLACE ">=" " >= " PARTY_REQUIRES "${PARTY_REQUIRES}")
  endif()
  set_property(GLOBAL PROPERTY "POINSOT_REQUIRES_${target}" "${PARTY_REQUIRES}")
  set_property(GLOBAL PROPERTY "POINSOT_DEBIAN_${target}" "${PARTY_DEBIAN}")
endmacro()
