# SPDX-License-Identifier: Apache-2.0
# poinsot_embed(TARGET SYMBOL FILE): puts FILE into TARGET as
#   extern "C" const unsigned char SYMBOL[], SYMBOL_end[];
# It uses .incbin, because a C array of a 700 kB font would be 4 MB of source.
function(poinsot_embed target symbol file)
  set(assembly ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.S)
  file(CONFIGURE OUTPUT ${assembly} @ONLY CONTENT [[
    .section .rodata
    .global @symbol@
    .global @symbol@_end
    .balign 16
@symbol@:
    .incbin "@file@"
@symbol@_end:
    .byte 0
    .section .note.GNU-stack,"",%progbits
]])
  set_source_files_properties(${assembly} PROPERTIES OBJECT_DEPENDS ${file})
  target_sources(${target} PRIVATE ${assembly})
endfunction()
