# SPDX-License-Identifier: Apache-2.0
# Run after glad, with FOLDER. Every name of glad's gets the prefix poinsot_: a program that draws has a glad of its own
# with the same names, and the linker would make one table of function pointers of the two. Each thread has a table of
# its own: EGL and OSMesa, which threads may use side by side, have different functions.
foreach(file src/gl.c include/glad/gl.h)
  file(READ ${FOLDER}/${file} text)
  string(REPLACE glad poinsot_glad text "${text}")
  string(REPLACE GLAD POINSOT_GLAD text "${text}")
  string(REPLACE <poinsot_glad/gl.h> <glad/gl.h> text "${text}")
  string(REGEX REPLACE "(PFN[A-Z0-9_]+PROC|int) (poinsot_glad_gl[A-Z]|POINSOT_GLAD_GL_VERSION)" "__thread \\1 \\2" text "${text}")
  file(WRITE ${FOLDER}/${file} "${text}")
endforeach()
