# SPDX-License-Identifier: Apache-2.0
# Changes the files that glad wrote into FOLDER. Every name of glad gets the prefix poinsot_, because a program that draws
# has its own glad, and the linker would merge the tables of function pointers. The table becomes thread-local, because
# threads may use EGL and OSMesa, which have different functions, at the same time.
foreach(file src/gl.c include/glad/gl.h)
  file(READ ${FOLDER}/${file} text)
  string(REPLACE glad poinsot_glad text "${text}")
  string(REPLACE GLAD POINSOT_GLAD text "${text}")
  string(REPLACE <poinsot_glad/gl.h> <glad/gl.h> text "${text}")
  string(REGEX REPLACE "(PFN[A-Z0-9_]+PROC|int) (poinsot_glad_gl[A-Z]|POINSOT_GLAD_GL_VERSION)" "__thread \\1 \\2" text "${text}")
  file(WRITE ${FOLDER}/${file} "${text}")
endforeach()
