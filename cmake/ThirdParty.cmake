# SPDX-License-Identifier: Apache-2.0
# poinsot_third_party(TARGET PACKAGE name [version ...] REQUIRES "module >= version" DEBIAN package)
# poinsot_third_party(PkgConfig::PREFIX MODULES module>=version ... DEBIAN package)
#
# Finds a library and keeps how it was found: who links an installed layer must find it too, by CMake (PACKAGE) or by
# pkg-config (REQUIRES). MODULES say both. DEBIAN is the package that has it. A macro, as variables of find_package() are
# its caller's.
macro(poinsot_third_party target)
  cmake_parse_arguments(PARTY "" "REQUIRES;DEBIAN" "PACKAGE;MODULES" ${ARGN})
  if(DEFINED PARTY_PACKAGE)
    find_package(${PARTY_PACKAGE} REQUIRED)
    list(JOIN PARTY_PACKAGE " " PARTY_WORDS)
    set_property(GLOBAL PROPERTY "POINSOT_FIND_${target}" "_poinsot_find_package(${PARTY_DEBIAN} ${PARTY_WORDS})")
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
