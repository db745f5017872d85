# SPDX-License-Identifier: Apache-2.0
# Precompiles the headers of Eigen, fmt and GoogleTest, because parsing them takes most of the compile time. Every file
# still includes all headers that it uses; a build with POINSOT_PCH=OFF checks that.
option(POINSOT_PCH "Precompile the headers of third parties" ON)

set(heavy_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <variant> <vector> <fmt/format.h> <Eigen/Core> <Eigen/Geometry>)

# Precompiles the headers in the target carrier. Its users must have the same flags, so libraries and programs have
# different carriers.
function(poinsot_heavy_headers carrier)
  target_link_libraries(${carrier} PRIVATE poinsot_flags Eigen3::Eigen fmt::fmt)
  target_precompile_headers(${carrier} PRIVATE ${heavy_headers} ${ARGN})
endfunction()

if(POINSOT_PCH)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/heavy_headers.cpp CONTENT "int main() {}\n")
  add_library(poinsot_layer_headers OBJECT ${PROJECT_BINARY_DIR}/heavy_headers.cpp)
  poinsot_heavy_headers(poinsot_layer_headers)
endif()

# Defines the carrier for test programs. Must follow find_package(GTest).
function(poinsot_test_headers)
  if(POINSOT_PCH)
    add_executable(poinsot_test_headers ${PROJECT_BINARY_DIR}/heavy_headers.cpp)
    target_link_libraries(poinsot_test_headers PRIVATE poinsot_test_flags GTest::gtest GTest::gmock)
    poinsot_heavy_headers(poinsot_test_headers <gtest/gtest.h> <gmock/gmock.h>)
  endif()
endfunction()

# Lets a target reuse the precompiled headers of a carrier. A compiler that cannot use them parses the headers instead,
# so their include folders are added.
function(poinsot_use_headers target carrier)
  if(POINSOT_PCH)
    target_precompile_headers(${target} REUSE_FROM ${carrier})
    foreach(party Eigen3::Eigen fmt::fmt)
      target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:${party},INTERFACE_INCLUDE_DIRECTORIES>)
    endforeach()
  endif()
endfunction()

# Precompiles the headers for one target with its own compile options, which a carrier's options would replace.
function(poinsot_own_headers target)
  if(POINSOT_PCH)
    target_precompile_headers(${target} PRIVATE ${heavy_headers})
  endif()
endfunction()
