# SPDX-License-Identifier: Apache-2.0
# Flags that every target of the project compiles and links with, each with its reason.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)

# The compilers that the project is held to, those of Debian 12 and 13; what a later one warns of is no reason not to build, nor is what the flags
# of a project around this one warn of.
set(held_to OFF)
if((CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL Clang AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 20))
  set(held_to ${PROJECT_IS_TOP_LEVEL})
endif()
option(POINSOT_WERROR "Warnings are errors" ${held_to})

add_library(poinsot_flags INTERFACE)
if(NOT PROJECT_IS_TOP_LEVEL)
  target_compile_options(poinsot_flags INTERFACE -fno-fast-math)  # the project around may have -ffast-math
endif()
target_compile_options(poinsot_flags INTERFACE
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=  # an assertion names its file, not the place of the build
  -pthread  # as third parties ask for it: with it for some targets only, those cannot share precompiled headers
  -ffp-contract=off       # a*b+c must not be fused where the CPU has FMA: same bits on every machine
  $<$<BOOL:${POINSOT_WERROR}>:-Werror>
  -Wall -Wextra -Wpedantic
  -Wshadow                # a shadowed frame letter is a wrong formula
  -Wnon-virtual-dtor
  -Wold-style-cast
  -Woverloaded-virtual
  -Wimplicit-fallthrough
  -Wextra-semi
  -Wformat=2)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 15)
  # It takes the members of a std::variant that are not the current one for uninitialised values that are read.
  target_compile_options(poinsot_flags INTERFACE -Wno-maybe-uninitialized)
endif()

# A test runs once: -O1 saves more time in compiling it than it costs in the run.
add_library(poinsot_test_flags INTERFACE)
target_link_libraries(poinsot_test_flags INTERFACE poinsot_flags)
target_compile_options(poinsot_test_flags INTERFACE $<$<CONFIG:Release>:-O1>)

# Scenes come from strangers: what a mistake of ours would let them do ends the program in its place.
target_compile_options(poinsot_flags INTERFACE -fstack-protector-strong -fstack-clash-protection)
check_cxx_compiler_flag(-fcf-protection POINSOT_HAS_CF_PROTECTION)  # x86
if(POINSOT_HAS_CF_PROTECTION)
  target_compile_options(poinsot_flags INTERFACE -fcf-protection)
endif()
# Fortified calls need optimisation; glibc warns without it. Sanitizers check these calls themselves.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_compile_options(poinsot_flags INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-U_FORTIFY_SOURCE>
    $<$<CONFIG:Release,RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
endif()
target_compile_definitions(poinsot_flags INTERFACE _GLIBCXX_ASSERTIONS)  # an index past the end of a vector
if(PROJECT_IS_TOP_LEVEL)  # options of a static library reach who links it
  target_link_options(poinsot_flags INTERFACE -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
endif()
check_pie_supported(LANGUAGES CXX)  # programs are linked to lie anywhere
