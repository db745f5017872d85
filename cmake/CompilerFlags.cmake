# SPDX-License-Identifier: Apache-2.0
# Flags that every target of the project compiles with, each with its reason.
add_library(poinsot_flags INTERFACE)
target_compile_options(poinsot_flags INTERFACE
  -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=  # an assertion names its file, not the place of the build
  -ffp-contract=off       # a*b+c must not be fused where the CPU has FMA: same bits on every machine
  -Wall -Wextra -Wpedantic
  -Wshadow                # a shadowed frame letter is a wrong formula
  -Wnon-virtual-dtor
  -Wold-style-cast
  -Woverloaded-virtual
  -Wimplicit-fallthrough
  -Wextra-semi)
