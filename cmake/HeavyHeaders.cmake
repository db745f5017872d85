# SPDX-License-Identifier: Apache-2.0
# What takes most of a compiler's time here is reading the headers of Eigen, fmt and GoogleTest: they are read
# once. Every file includes what it uses all the same; POINSOT_PCH=OFF builds without, and shows it.
option(POINSOT_PCH "Precompile the headers of third parties" ON)

set(heavy_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <variant> <vector> <fmt/format.h> <Eigen/Core> <Eigen/Geometry>)

# A target of its own carries them, as flags must be those of its users: libraries or programs.
function(poinsot_heavy_headers carrier)
  target_link_libraries(${carrier} PRIVATE poinsot_flags Eigen3::Eigen fmt::fmt)
  target_precompile_headers(${carrier} PRIVATE ${heavy_headers} ${ARGN})
endfunction()

if(POINSOT_PCH)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/heavy_headers.cpp CONTENT "int main() {}\n")
  add_library(poinsot_layer_headers OBJECT ${PROJECT_BINARY_DIR}/heavy_headers.cpp)
  poinsot_heavy_headers(poinsot_layer_headers)
endif()

# After find_package(GTest).
function(poinsot_test_headers)
  if(POINSOT_PCH)
    add_executable(poinsot_test_headers ${PROJECT_BINARY_DIR}/heavy_headers.cpp)
    target_link_libraries(poinsot_test_headers PRIVATE poinsot_test_flags GTest::gtest GTest::gmock)
    poinsot_heavy_headers(poinsot_test_headers <gtest/gtest.h> <gmock/gmock.h>)
  endif()
endfunction()

# Lets a target use what its kind's carrier has read. A compiler that cannot use it reads the headers themselves, and must
# find them.
function(poinsot_use_headers target carrier)
  if(POINSOT_PCH)
    target_precompile_headers(${target} REUSE_FROM ${carrier})
    foreach(party Eigen3::Eigen fmt::fmt)
      target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:${party},INTERFACE_INCLUDE_DIRECTORIES>)
    endforeach()
  endif()
endfunction()

# For a target with options of its own, in whose place those would come that the carrier was made with.
function(poinsot_own_headers target)
  if(POINSOT_PCH)
    target_precompile_headers(${target} PRIVATE ${heavy_headers})
  endif()
endfunction()
