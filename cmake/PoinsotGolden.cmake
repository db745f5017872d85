# SPDX-License-Identifier: Apache-2.0
# Golden images as tests of a project: by find_package(poinsot COMPONENTS golden).
#
#   poinsot_add_golden_test(NAME racket SCENE scenes/racket.toml BASELINE approved/racket.png
#                           [TIME "1.5 s"] [SIZE 256 144] [SET style.theme=dark ...])
#   poinsot_add_golden_test(NAME plot COMMAND my_program --plot plot.png IMAGE plot.png BASELINE approved/plot.png
#                           [WORKING_DIRECTORY folder])
#       [MAX 0-2] [PIXELS 0-0.5%] [FLIP_MEAN 0-1e-3] [FLIP_MAX 0-0.05] [REASON "why"] [LABELS ...]
#
# A test NAME that compares the picture of a scene, or the one that a command writes, with what was approved. A limit
# that is not the default needs a REASON. Paths are from the current source folder; of COMMAND and IMAGE, from
# WORKING_DIRECTORY (default: the current binary folder). The new picture, maps, report.html and junit.xml are in
# golden/NAME of the binary folder. The target poinsot_golden_update approves the pictures of all tests, and
# poinsot_golden_update_NAME that of one.
include_guard(GLOBAL)

find_program(POINSOT_PROGRAM poinsot HINTS ${CMAKE_CURRENT_LIST_DIR}/../../../bin ${CMAKE_CURRENT_LIST_DIR}/../../../../bin
  DOC "The program poinsot, which compares golden images")

# A text as TOML has it.
function(_poinsot_toml result value)
  string(REPLACE "\\" "\\\\" value "${value}")
  string(REPLACE "\"" "\\\"" value "${value}")
  set(${result} "\"${value}\"" PARENT_SCOPE)
endfunction()

function(poinsot_add_golden_test)
  set(limits MAX PIXELS FLIP_MEAN FLIP_MAX REASON)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "NAME;SCENE;TIME;IMAGE;BASELINE;WORKING_DIRECTORY;${limits}"
    "COMMAND;SIZE;SET;LABELS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "poinsot_add_golden_test: what is ${ARG_UNPARSED_ARGUMENTS}?")
  endif()
  if(NOT ARG_NAME MATCHES "^[A-Za-z0-9_-][A-Za-z0-9_.-]*$" OR NOT ARG_BASELINE MATCHES "[.]png$")
    message(FATAL_ERROR "poinsot_add_golden_test: expected NAME name (letters, digits, _ - .) and BASELINE file.png")
  endif()
  if((DEFINED ARG_SCENE AND DEFINED ARG_COMMAND) OR
      NOT (DEFINED ARG_SCENE OR (DEFINED ARG_COMMAND AND DEFINED ARG_IMAGE)))
    message(FATAL_ERROR "poinsot_add_golden_test(${ARG_NAME}): expected SCENE file, or COMMAND words and IMAGE file")
  endif()
  if(NOT POINSOT_PROGRAM)
    message(FATAL_ERROR "poinsot_add_golden_test: the program poinsot is missing; set POINSOT_PROGRAM")
  endif()
  set(working ${CMAKE_CURRENT_BINARY_DIR})
  if(ARG_WORKING_DIRECTORY)
    get_filename_component(working ${ARG_WORKING_DIRECTORY} ABSOLUTE)
  endif()

  # ---- what is compared: a golden.toml of one test, which is called as its reference is
  get_filename_component(baseline ${ARG_BASELINE} ABSOLUTE)
  get_filename_component(reference ${baseline} NAME_WE)
  get_filename_component(references ${baseline} DIRECTORY)
  _poinsot_toml(references ${references})
  set(text "references = ${references}\n[[test]]\nname = \"${reference}\"\n")
  if(DEFINED ARG_SCENE)
    get_filename_component(scene ${ARG_SCENE} ABSOLUTE)
    _poinsot_toml(word ${scene})
    string(APPEND text "scene = ${word}\n")
    if(DEFINED ARG_TIME)
      _poinsot_toml(time "${ARG_TIME}")
      if(ARG_TIME MATCHES "^[0-9.]+$")
        set(time "${ARG_TIME}")
      endif()
      string(APPEND text "times = [${time}]\n")
    endif()
    if(DEFINED ARG_SIZE)
      if(NOT "${ARG_SIZE}" MATCHES "^[0-9]+;[0-9]+$")
        message(FATAL_ERROR "poinsot_add_golden_test(${ARG_NAME}): expected SIZE width height, got ${ARG_SIZE}")
      endif()
      list(JOIN ARG_SIZE ", " size)
      string(APPEND text "size = [${size}]\n")
    endif()
    foreach(word ${ARG_SET})
      _poinsot_toml(word ${word})
      list(APPEND words ${word})
    endforeach()
    if(words)
      list(JOIN words ", " words)
      string(APPEND text "set = [${words}]\n")
    endif()
  else()
    get_filename_component(image ${ARG_IMAGE} ABSOLUTE BASE_DIR ${working})
    _poinsot_toml(word ${image})
    string(APPEND text "image = ${word}\n")
  endif()
  set(rule "")
  foreach(limit ${limits})
    if(DEFINED ARG_${limit})
      string(TOLOWER ${limit} key)
      _poinsot_toml(value "${ARG_${limit}}")
      string(APPEND rule "${key} = ${value}\n")
    endif()
  endforeach()
  if(rule)
    if(NOT DEFINED ARG_REASON)
      message(FATAL_ERROR "poinsot_add_golden_test(${ARG_NAME}): a limit that is not the default needs a REASON")
    endif()
    string(PREPEND rule "[test.rule]\n")
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/golden/${ARG_NAME})
  file(WRITE ${folder}/golden.toml "${text}${rule}")

  # ---- the test, and what approves
  # Where this project says that they are, which a golden.toml may not by itself.
  set(golden ${POINSOT_PROGRAM} golden ${folder}/golden.toml --only ${reference} -o ${folder})
  foreach(file ${baseline} ${scene} ${image})
    get_filename_component(place ${file} DIRECTORY)
    list(APPEND golden --asset-root ${place})
  endforeach()
  if(DEFINED ARG_COMMAND)
    # A picture of an earlier run must not stand for one that the command does not write any more.
    set(forget ${CMAKE_COMMAND} -E rm -f ${image})
    add_test(NAME ${ARG_NAME}.forgotten COMMAND ${forget})
    add_test(NAME ${ARG_NAME}.made COMMAND ${ARG_COMMAND} WORKING_DIRECTORY ${working})
    set_tests_properties(${ARG_NAME}.forgotten PROPERTIES
      FIXTURES_SETUP poinsot_golden_${ARG_NAME}.forgotten LABELS "${ARG_LABELS}")
    set_tests_properties(${ARG_NAME}.made PROPERTIES FIXTURES_REQUIRED poinsot_golden_${ARG_NAME}.forgotten
      FIXTURES_SETUP poinsot_golden_${ARG_NAME} LABELS "${ARG_LABELS}")
  endif()
  add_test(NAME ${ARG_NAME} COMMAND ${golden} --report ${folder}/report.html --junit ${folder}/junit.xml)
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS "${ARG_LABELS}")
  if(DEFINED ARG_COMMAND)
    set_tests_properties(${ARG_NAME} PROPERTIES FIXTURES_REQUIRED poinsot_golden_${ARG_NAME})
    set(make COMMAND ${forget} COMMAND ${ARG_COMMAND})
  endif()
  add_custom_target(poinsot_golden_update_${ARG_NAME} ${make} COMMAND ${golden} --update
    WORKING_DIRECTORY ${working} VERBATIM USES_TERMINAL)
  if(NOT TARGET poinsot_golden_update)
    add_custom_target(poinsot_golden_update)
  endif()
  add_dependencies(poinsot_golden_update poinsot_golden_update_${ARG_NAME})
endfunction()
