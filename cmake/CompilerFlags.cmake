# SPDX-License-Identifier: Apache-2.0
# Flags that every target of the project compiles and links with, each with its reason.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)

# Warnings are errors only with the compilers of Debian 12 and 13, and only if this is the top-level project: new
# warnings of a later compiler, or of the flags of an enclosing project, must not break the build.
set(held_to OFF)
if((CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL Clang AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 20))
  set(held_to ${PROJECT_IS_TOP_LEVEL})
endif()
option(POINSOT_WERROR "Warnings are errors" ${held_to})

add_library(poinsot_flags INTERFACE)
if(NOT PROJECT_IS_TOP_LEVEL)
  target_compile_options(poinsot_flags INTERFACE -fno-fast-math)  # the enclosing project may use -ffast-math
endif()
target_compile_options(poinsot_flags INTERFACE
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=  # assertions print paths relative to the sources
  -pthread  # third parties require it for some targets, and only targets with equal flags share precompiled headers
  -ffp-contract=off       # no fused a*b+c on CPUs with FMA: results have the same bits on every machine
  $<$<BOOL:${POINSOT_WERROR}>:-Werror>
  -Wall -Wextra -Wpedantic
  -Wshadow                # a shadowed name of a reference frame makes a formula wrong
  -Wnon-virtual-dtor
  -Wold-style-cast
  -Woverloaded-virtual
  -Wimplicit-fallthrough
  -Wextra-semi
  -Wformat=2)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 15)
  # False positives: GCC 15 and later report inactive members of a std::variant as uninitialised.
  target_compile_options(poinsot_flags INTERFACE -Wno-maybe-uninitialized)
endif()

# Tests use -O1: each test runs once, so -O1 saves more time in compiling than it costs in the run.
add_library(poinsot_test_flags INTERFACE)
target_link_libraries(poinsot_test_flags INTERFACE poinsot_flags)
target_compile_options(poinsot_test_flags INTERFACE $<$<CONFIG:Release>:-O1>)

# Hardening: scenes may come from strangers, so a memory error must end the program before a scene can exploit it.
target_compile_options(poinsot_flags INTERFACE -fstack-protector-strong -fstack-clash-protection)
check_cxx_compiler_flag(-fcf-protection POINSOT_HAS_CF_PROTECTION)  # x86 only
if(POINSOT_HAS_CF_PROTECTION)
  target_compile_options(poinsot_flags INTERFACE -fcf-protection)
endif()
# Fortified calls need optimisation; glibc warns without it. Sanitizers check these calls themselves.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_compile_options(poinsot_flags INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-U_FORTIFY_SOURCE>
    $<$<CONFIG:Release,RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
endif()
target_compile_definitions(poinsot_flags INTERFACE _GLIBCXX_ASSERTIONS)  # bounds checks in the standard library
if(PROJECT_IS_TOP_LEVEL)  # link options of a static library also apply to programs that link it
  target_link_options(poinsot_flags INTERFACE -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
endif()
check_pie_supported(LANGUAGES CXX)  # link programs as position-independent executables
