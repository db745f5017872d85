# SPDX-License-Identifier: Apache-2.0
# Tests that PROGRAM prints the same hash with the CPU's vector units hidden from the C library, and that its other
# builds print it, too: cmake -DPROGRAM=... "-DOTHERS=name=program|name=program" -P compare_hashes.cmake
function(hash_of result program)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GLIBC_TUNABLES=${tunables} ${program} ${ARGN}
    OUTPUT_VARIABLE output RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0 OR output STREQUAL "")
    message(FATAL_ERROR "${program} failed: ${status}")
  endif()
  set(${result} ${output} PARENT_SCOPE)
endfunction()

# AVX2 and FMA are the names of glibc 2.33 and later, AVX2_Usable and FMA_Usable those of older versions.
set(hidden "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable")

hash_of(plain ${PROGRAM})
message(STATUS "as built: ${plain}")

# Control: hiding must change results of the C library's own functions, or the next comparison proves nothing.
hash_of(libm ${PROGRAM} --libm)
set(tunables ${hidden})
hash_of(libm_hidden ${PROGRAM} --libm)
hash_of(without_vector_units ${PROGRAM})
set(tunables "")
if(libm STREQUAL libm_hidden)
  message(STATUS "NOTE: hiding AVX2 and FMA changes nothing in this C library on this CPU: that part shows nothing")
else()
  message(STATUS "hiding AVX2 and FMA changes the C library's functions: ${libm} -> ${libm_hidden}")
endif()

set(names "without AVX2 and FMA")
set(hashes ${without_vector_units})
string(REPLACE "|" ";" OTHERS "${OTHERS}")
foreach(other IN LISTS OTHERS)
  string(REGEX MATCH "^([^=]+)=(.+)$" matched "${other}")
  list(APPEND names "${CMAKE_MATCH_1}")
  hash_of(hash ${CMAKE_MATCH_2})
  list(APPEND hashes ${hash})
endforeach()

set(failed FALSE)
foreach(name hash IN ZIP_LISTS names hashes)
  message(STATUS "${name}: ${hash}")
  if(NOT hash STREQUAL plain)
    set(failed TRUE)
  endif()
endforeach()
if(failed)
  message(FATAL_ERROR "the trajectory depends on the machine, on the optimiser or on the compiler")
endif()
