# SPDX-License-Identifier: Apache-2.0
# poinsot_embed_shaders(TARGET): embeds every file of shaders/ and writes a table of their names and contents.
include(EmbedFile)
function(poinsot_embed_shaders target)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
  set(declarations "")
  set(rows "")
  foreach(file ${files})
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER "poinsot_shader_${name}" symbol)
    poinsot_embed(${target} ${symbol} ${file})
    string(APPEND declarations "extern const unsigned char ${symbol}[], ${symbol}_end[];\n")
    string(APPEND rows "    {\"${name}\", ${symbol}, ${symbol}_end},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/embedded_shaders.inc @ONLY CONTENT
    "extern \"C\" {\n${declarations}}\nconst EmbeddedShader kEmbeddedShaders[] = {\n${rows}};\n")
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
