# SPDX-License-Identifier: Apache-2.0
include(GNUInstallDirs)
set(POINSOT_INSTALL_HEADERS ${CMAKE_INSTALL_INCLUDEDIR}/poinsot)

# Renaming symbols in an archive has no effect with link-time optimisation, which does not read these symbols.
set(POINSOT_OWN_INLINES OFF)
if(NOT CMAKE_NM OR NOT CMAKE_OBJCOPY OR CMAKE_INTERPROCEDURAL_OPTIMIZATION OR CMAKE_CXX_FLAGS MATCHES "-flto")
  message(STATUS "Inline functions keep common names, because OwnInlines.cmake needs nm, objcopy and no link-time optimisation")
else()
  set(POINSOT_OWN_INLINES ON)
endif()

# A program must define this macro if the library was built with it (src/core/abi.h).
if(CMAKE_CXX_FLAGS MATCHES "-D_GLIBCXX_DEBUG")
  set(POINSOT_CFLAGS -DPOINSOT_BUILT_WITH_GLIBCXX_DEBUG)
  add_compile_options(${POINSOT_CFLAGS})
endif()

# poinsot_joined(TARGET N SOURCES...): compiles the sources in groups of N, because most of the compile time goes into
# headers and templates that the sources share. Two sources must therefore not define the same name in an unnamed
# namespace. A source of two targets is in the group that the later call gives it.
option(POINSOT_JOINED "Compile several sources as one; OFF for tools that need a compile command for each source"
  ${PROJECT_IS_TOP_LEVEL})
# A source that differs from the last commit is compiled on its own, because it will soon be edited again.
set(POINSOT_EDITED "")
if(PROJECT_IS_TOP_LEVEL)
  foreach(list "diff --name-only --relative HEAD" "ls-files --others --exclude-standard")
    separate_arguments(list)
    execute_process(COMMAND git ${list} -- *.cpp WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
      OUTPUT_VARIABLE edited ERROR_QUIET)
    string(REPLACE "\n" ";" edited "${edited}")
    list(APPEND POINSOT_EDITED ${edited})
  endforeach()
endif()

function(poinsot_joined target most)
  if(NOT POINSOT_JOINED OR NOT ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)  # even if the enclosing project sets it to ON
    return()
  endif()
  set(number 0)
  foreach(source ${ARGN})
    math(EXPR group "${number} / ${most}")
    math(EXPR number "${number} + 1")
    cmake_path(ABSOLUTE_PATH source NORMALIZE OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    if(NOT path IN_LIST POINSOT_EDITED)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC warns about unnamed namespaces outside the main source, and joined sources are included into another one.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# poinsot_layer(NAME SOURCES a.cpp b.cpp [APART c.cpp] LINKS poinsot::core ... [PRIVATE lib...]
#   [HEADER_ONLY lib...] [OPENED lib...] [OPTIONS option...])
#
# Makes a static library of one folder of src/. APART: sources that are compiled one by one. LINKS: layers, and
# header-only libraries that the layer's headers include. PRIVATE: third parties that only the layer's .cpp files
# include. HEADER_ONLY: third parties of the .cpp files that need no linking. OPENED: third parties whose headers are
# included, and which are opened at run time instead of linked. OPTIONS: compile options of the layer.
function(poinsot_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;APART;LINKS;PRIVATE;HEADER_ONLY;OPENED;OPTIONS" ${ARGN})
  add_library(poinsot_${name} STATIC ${ARG_SOURCES} ${ARG_APART})
  poinsot_joined(poinsot_${name} 8 ${ARG_SOURCES})
  add_library(poinsot::${name} ALIAS poinsot_${name})
  target_include_directories(poinsot_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${POINSOT_INSTALL_HEADERS}>)
  target_compile_features(poinsot_${name} INTERFACE cxx_std_20)
  target_compile_options(poinsot_${name} INTERFACE ${POINSOT_CFLAGS})
  # BUILD_INTERFACE hides targets that a project with the installed library does not need.
  target_link_libraries(poinsot_${name} PUBLIC ${ARG_LINKS} PRIVATE $<BUILD_INTERFACE:poinsot_flags> ${ARG_PRIVATE})
  foreach(library ${ARG_HEADER_ONLY})
    target_link_libraries(poinsot_${name} PRIVATE $<BUILD_INTERFACE:${library}>)
  endforeach()
  foreach(library ${ARG_OPENED})
    target_include_directories(poinsot_${name} SYSTEM PRIVATE
      $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  if(POINSOT_OWN_INLINES)
    add_custom_command(TARGET poinsot_${name} POST_BUILD VERBATIM COMMAND ${CMAKE_COMMAND}
      -DARCHIVE=$<TARGET_FILE:poinsot_${name}> -DNM=${CMAKE_NM} -DOBJCOPY=${CMAKE_OBJCOPY}
      -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/OwnInlines.cmake)
  endif()
  if(ARG_OPTIONS)
    target_compile_options(poinsot_${name} PRIVATE ${ARG_OPTIONS})
    poinsot_own_headers(poinsot_${name})
  else()
    poinsot_use_headers(poinsot_${name} poinsot_layer_headers)
  endif()
  set_property(GLOBAL APPEND PROPERTY POINSOT_LAYERS ${name})
  set_property(GLOBAL PROPERTY POINSOT_LINKS_${name} ${ARG_LINKS} ${ARG_PRIVATE})
endfunction()

# poinsot_test(NAME SOURCES ... [APART ...] LINKS ... LABELS unit|gl|golden|video|cli|slow...)
# Makes a GoogleTest program. Each of its cases is a test of CTest with the labels; `ctest -L unit` takes seconds.
function(poinsot_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;APART;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES} ${ARG_APART})
  poinsot_joined(${name} 5 ${ARG_SOURCES})
  # False positives: g++ 12 reports concatenated strings as writes past their ends (GCC bug 105651) and, at -O1, a
  # comparison before a delete as a use after it.
  target_compile_options(${name} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-use-after-free>)
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} poinsot_test_support poinsot_test_flags GTest::gtest
    GTest::gmock GTest::gtest_main)
  poinsot_use_headers(${name} poinsot_test_headers)
  gtest_discover_tests(${name} NO_PRETTY_VALUES PROPERTIES LABELS "${ARG_LABELS}"
    ENVIRONMENT "POINSOT_CACHE=${PROJECT_BINARY_DIR}/cache" DISCOVERY_TIMEOUT 60)
endfunction()
