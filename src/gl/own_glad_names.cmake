# SPDX-License-Identifier: Apache-2.0
# Run after glad, with FOLDER: every name of glad's gets the prefix poinsot_, as a program that draws has a glad of its own
# with the same names, and the linker would make one table of function pointers of the two.
foreach(file src/gl.c include/glad/gl.h)
  file(READ ${FOLDER}/${file} text)
  string(REPLACE glad poinsot_glad text "${text}")
  string(REPLACE GLAD POINSOT_GLAD text "${text}")
  string(REPLACE <poinsot_glad/gl.h> <glad/gl.h> text "${text}")
  file(WRITE ${FOLDER}/${file} "${text}")
endforeach()
