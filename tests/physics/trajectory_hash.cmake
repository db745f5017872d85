# SPDX-License-Identifier: Apache-2.0
# Tests that motions have the same bits on every CPU, at every optimisation level and from another compiler. Compares
# this build, this build with the CPU's vector units hidden from the C library, and further builds of the sources.

# Sources of the hashed motions, and all sources that these call. If one is missing, linking fails.
set(hash_sources composition.cpp decaying_motion.cpp driven_motion.cpp driven_trajectory.cpp elliptic.cpp forcing.cpp
  forcing_piece.cpp free_flow.cpp free_motion.cpp free_motion_constants.cpp herpolhode.cpp inertia_tensor.cpp motion.cpp
  polhode.cpp principal_axes.cpp principal_moments.cpp scaled_start.cpp splitting.cpp step_choice.cpp step_plan.cpp
  symmetric_eigen.cpp transcendental.cpp)
list(TRANSFORM hash_sources PREPEND ${PROJECT_SOURCE_DIR}/src/physics/)
list(PREPEND hash_sources ${CMAKE_CURRENT_SOURCE_DIR}/trajectory_hash.cpp)
# Each variant compiles these sources as one.
list(TRANSFORM hash_sources REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE hash_includes)
list(JOIN hash_includes "" hash_includes)
set(hash_source ${CMAKE_CURRENT_BINARY_DIR}/trajectory_hash_all.cpp)
file(CONFIGURE OUTPUT ${hash_source} CONTENT "${hash_includes}" @ONLY)

add_executable(physics_trajectory_hash trajectory_hash.cpp)
target_link_libraries(physics_trajectory_hash PRIVATE poinsot::physics poinsot_flags)

# No warnings: the build of the libraries gives them already, and Clang 19 warns about -march=native on some processors.
get_target_property(physics_options poinsot_physics COMPILE_OPTIONS)
function(hash_variant name)
  add_executable(physics_trajectory_hash_${name} ${hash_source})
  target_compile_options(physics_trajectory_hash_${name} PRIVATE ${physics_options} -w ${ARGN})
  target_include_directories(physics_trajectory_hash_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(physics_trajectory_hash_${name} PRIVATE poinsot::core Eigen3::Eigen poinsot_flags)
endfunction()
hash_variant(o0 -O0)
hash_variant(o3 -O3)
hash_variant(native -O3 -march=native)
string(JOIN "|" variants "-O0=$<TARGET_FILE:physics_trajectory_hash_o0>"
  "-O3=$<TARGET_FILE:physics_trajectory_hash_o3>"
  "-O3 -march native=$<TARGET_FILE:physics_trajectory_hash_native>")
add_test(NAME Physics.TrajectoryIsTheSameOnEveryCpu
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:physics_trajectory_hash> "-DOTHERS=${variants}"
          -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_hashes.cmake)

# CMake supports one compiler per build, so custom commands call the other one.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  find_program(POINSOT_OTHER_COMPILER NAMES g++)
else()
  find_program(POINSOT_OTHER_COMPILER NAMES clang++)
endif()
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize|--coverage")
  set(other_compiler "")  # the other compiler cannot link core, which calls the runtime library of this compiler
else()
  set(other_compiler ${POINSOT_OTHER_COMPILER})
endif()
if(other_compiler)
  set(other ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/physics_trajectory_hash_other)
  file(GLOB hash_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/physics/*.h)
  get_target_property(eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_custom_command(OUTPUT ${other}
    COMMAND ${other_compiler} -std=c++20 -O3 -march=native -w -ffp-contract=off ${physics_options} -I ${PROJECT_SOURCE_DIR}/src
            -isystem ${eigen_folder} ${hash_source} $<TARGET_FILE:poinsot_core> $<TARGET_FILE:fmt::fmt> -o ${other}
    DEPENDS ${hash_source} ${hash_sources} ${hash_headers} poinsot_core
    COMMENT "Building the trajectory hash with ${other_compiler}")
  add_custom_target(physics_trajectory_hash_other ALL DEPENDS ${other})
  add_test(NAME Physics.TrajectoryIsTheSameFromAnotherCompiler
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:physics_trajectory_hash>
            "-DOTHERS=${other_compiler}=${other}" -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_hashes.cmake)
else()
  add_test(NAME Physics.TrajectoryIsTheSameFromAnotherCompiler
    COMMAND ${CMAKE_COMMAND} -E echo "SKIPPED: no second compiler (clang++) for this build")
  set_tests_properties(Physics.TrajectoryIsTheSameFromAnotherCompiler PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")
endif()
set_tests_properties(Physics.TrajectoryIsTheSameOnEveryCpu Physics.TrajectoryIsTheSameFromAnotherCompiler
  PROPERTIES LABELS unit)
