# SPDX-License-Identifier: Apache-2.0
# Run after an archive was made, with ARCHIVE, NM and OBJCOPY: gives the archive's inline functions names of their own.
#
# An inline function of Eigen, of GLM or of the standard library is compiled into our archive and into the program that
# links it. Of two such functions with one name the linker keeps one, for all callers. If the program is compiled for
# another vector unit or with -ffast-math, the library would then run code with other last bits, and the program code
# that aligns otherwise. The suffix parts the two; debuggers and c++filt show it as [clone .poinsot].
#
# Renamed are weak functions and the names of their sections' groups (nm: n). Weak data, such as a static variable of an
# inline function, must stay one for the whole program. Names in poinsot stay too: an explicit instantiation is weak, and
# other archives call it; inline functions of our public headers hold no formulas.
execute_process(COMMAND ${NM} --defined-only --format=posix ${ARCHIVE} OUTPUT_VARIABLE symbols ERROR_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n_Z[^ \n]+ [Wn] " symbols "${symbols}")
list(FILTER symbols EXCLUDE REGEX "\n_Z+N[VKRO]*7poinsot|[.]poinsot ")
list(TRANSFORM symbols REPLACE "^\n([^ ]+) .*" "\\1 \\1.poinsot\n")
list(REMOVE_DUPLICATES symbols)
list(JOIN symbols "" symbols)
file(WRITE ${ARCHIVE}.names "${symbols}")
execute_process(COMMAND ${OBJCOPY} --redefine-syms=${ARCHIVE}.names ${ARCHIVE} COMMAND_ERROR_IS_FATAL ANY)
