# SPDX-License-Identifier: Apache-2.0
# cmake -DPROGRAM=... -DOTHER=... -P: the two programs print the same with and without the CPU's vector units in libm.
function(hash_of program tunables result)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GLIBC_TUNABLES=${tunables} ${program}
    OUTPUT_VARIABLE output RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0 OR output STREQUAL "")
    message(FATAL_ERROR "${program} failed: ${status}")
  endif()
  set(${result} ${output} PARENT_SCOPE)
endfunction()

hash_of(${PROGRAM} "" plain)
hash_of(${PROGRAM} "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable,-AVX512F,-SSE4_1" restricted)
hash_of(${OTHER} "" other)
message(STATUS "hashes: ${plain} ${restricted} ${other}")
if(NOT plain STREQUAL restricted OR NOT plain STREQUAL other)
  message(FATAL_ERROR "the trajectory depends on the machine or on the optimiser")
endif()
