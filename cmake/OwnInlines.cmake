# SPDX-License-Identifier: Apache-2.0
# Gives inline functions in a static library a suffix. Runs after the library is made, with ARCHIVE, NM and OBJCOPY.
#
# An inline function of Eigen, GLM or the standard library is compiled into our library and into the program that links
# it. If two functions have the same name, the linker keeps one for all callers. If the program is compiled for another
# vector unit or with -ffast-math, the library would then run code with different last bits, and the program code with
# different alignment. The suffix separates both functions; debuggers and c++filt show it as [clone .poinsot].
#
# Weak functions and the names of their section groups (nm: n) are renamed. Weak data, such as a static variable of an
# inline function, must stay shared by the whole program. Names in the namespace poinsot stay, too: other archives call
# explicit instantiations, which are weak, and the inline functions of our public headers contain no formulas.
execute_process(COMMAND ${NM} --defined-only --format=posix ${ARCHIVE} OUTPUT_VARIABLE symbols ERROR_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n_Z[^ \n]+ [Wn] " symbols "${symbols}")
list(FILTER symbols EXCLUDE REGEX "\n_Z+N[VKRO]*7poinsot|[.]poinsot ")
list(TRANSFORM symbols REPLACE "^\n([^ ]+) .*" "\\1 \\1.poinsot\n")
list(REMOVE_DUPLICATES symbols)
list(JOIN symbols "" symbols)
file(WRITE ${ARCHIVE}.names "${symbols}")
execute_process(COMMAND ${OBJCOPY} --redefine-syms=${ARCHIVE}.names ${ARCHIVE} COMMAND_ERROR_IS_FATAL ANY)
