# SPDX-License-Identifier: Apache-2.0
# Golden-image tests for projects with find_package(poinsot COMPONENTS golden). docs/packages.md explains both functions.
#
#   poinsot_add_golden_test(NAME racket SCENE scenes/racket.toml BASELINE approved/racket.png
#                           [TIME "1.5 s"] [SIZE 256 144] [SET style.theme=dark ...])
#   poinsot_add_golden_test(NAME plot COMMAND my_program --plot plot.png IMAGE plot.png BASELINE approved/plot.png
#                           [WORKING_DIRECTORY folder])
#       [MAX 0-2] [PIXELS 0-0.5%] [FLIP_MEAN 0-1e-3] [FLIP_MAX 0-0.05] [REASON "why"] [LABELS ...]
#
# Adds a test NAME that compares one picture, of a scene or of a command, with the approved one. A limit that is not the
# default needs a REASON. Paths are relative to the current source folder; those of COMMAND and IMAGE, to
# WORKING_DIRECTORY (default: the current binary folder). COMMAND adds two tests that run before NAME: NAME.clear removes
# IMAGE, NAME.run runs COMMAND.
#
#   poinsot_add_golden_suite(golden.toml [NAME name] [WORKING_DIRECTORY folder] [VARIANT name] [LABELS ...]
#                            [FIXTURES_REQUIRED ...])
#
# Adds a test NAME.CASE for each case of a golden.toml, one for each pattern of images (NAME.new/*.png), and NAME.unused,
# which fails if a reference belongs to no test. NAME is the file's name by default. Paths of images are relative to
# WORKING_DIRECTORY (default: the current binary folder).
#
# New pictures, maps, report.html and junit.xml of a test are in golden/TEST of the build folder, and golden/index.html
# there lists all tests of the build. The target poinsot_golden_update approves all new pictures,
# poinsot_golden_update_NAME those of one test or suite, poinsot_golden_update_NAME.CASE one.
include_guard(GLOBAL)

find_program(POINSOT_PROGRAM poinsot HINTS ${CMAKE_CURRENT_LIST_DIR}/../../../bin ${CMAKE_CURRENT_LIST_DIR}/../../../../bin
  DOC "The program poinsot, which compares golden images")
set(_POINSOT_GOLDEN_INDEX ${CMAKE_CURRENT_LIST_DIR}/PoinsotGoldenIndex.html.in CACHE INTERNAL "")

# Sets result to a text as a quoted TOML string.
function(_poinsot_toml result value)
  string(REPLACE "\\" "\\\\" value "${value}")
  string(REPLACE "\"" "\\\"" value "${value}")
  set(${result} "\"${value}\"" PARENT_SCOPE)
endfunction()

# Sets result to a text with the special characters of HTML escaped.
function(_poinsot_html result value)
  string(REPLACE "&" "&amp;" value "${value}")
  string(REPLACE "<" "&lt;" value "${value}")
  string(REPLACE ">" "&gt;" value "${value}")
  set(${result} "${value}" PARENT_SCOPE)
endfunction()

# Sets result to a test's name as a valid name of folders and targets. A hash keeps names with replaced characters unique.
function(_poinsot_golden_id result test)
  string(REGEX REPLACE "[^A-Za-z0-9_.+-]" "_" id "${test}")
  if(NOT id STREQUAL test)
    string(SHA1 hash "${test}")
    string(SUBSTRING ${hash} 0 8 hash)
    string(APPEND id .${hash})
  endif()
  set(${result} ${id} PARENT_SCOPE)
endfunction()

# Writes the page that lists all golden tests. It is called at the end of configuration, when all tests are known.
function(_poinsot_golden_write_index)
  get_property(POINSOT_ROWS GLOBAL PROPERTY POINSOT_GOLDEN_ROWS)
  _poinsot_html(POINSOT_TITLE "${CMAKE_PROJECT_NAME}")
  configure_file(${_POINSOT_GOLDEN_INDEX} ${CMAKE_BINARY_DIR}/golden/index.html @ONLY)
  message(STATUS "Golden tests: ${CMAKE_BINARY_DIR}/golden/index.html")
endfunction()

function(_poinsot_golden_add_to_index test id)
  get_property(rows GLOBAL PROPERTY POINSOT_GOLDEN_ROWS)
  if("${rows}" STREQUAL "")
    cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL _poinsot_golden_write_index)
  endif()
  _poinsot_html(name "${test}")
  set_property(GLOBAL APPEND_STRING PROPERTY POINSOT_GOLDEN_ROWS
    "<tr data-id=\"${id}\"><td class=\"status\">not run</td><td>${name}</td><td></td><td></td></tr>\n")
endfunction()

# Adds a test that runs COMMAND, `poinsot golden FILE ...`, with reports in a folder of its own. CHOICE selects
# tests of FILE; it is one word, because brackets in the name of a picture would break a list.
function(_poinsot_golden_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "TEST;CHOICE;WORKING_DIRECTORY" "COMMAND;LABELS;FIXTURES_REQUIRED")
  _poinsot_golden_id(id "${ARG_TEST}")
  set(folder ${CMAKE_BINARY_DIR}/golden/${id})
  file(MAKE_DIRECTORY ${folder})
  set(build "${CMAKE_BINARY_DIR}")
  if(NOT build MATCHES "^[A-Za-z0-9_./+-]*$")
    set(build "'${build}'")
  endif()
  add_test(NAME "${ARG_TEST}" WORKING_DIRECTORY ${ARG_WORKING_DIRECTORY} COMMAND ${ARG_COMMAND} "${ARG_CHOICE}"
    -o ${folder} --report ${folder}/report.html --junit ${folder}/junit.xml --outcome ${folder}/outcome.js
    --approve-by "cmake --build ${build} --target poinsot_golden_update_${id}")
  set_tests_properties("${ARG_TEST}" PROPERTIES LABELS "${ARG_LABELS}" FIXTURES_REQUIRED "${ARG_FIXTURES_REQUIRED}"
    ATTACHED_FILES_ON_FAIL ${folder}/report.html)  # attaches the page to a CDash dashboard
  _poinsot_golden_add_to_index("${ARG_TEST}" ${id})
endfunction()

# Adds the update target of one test or suite to poinsot_golden_update.
function(_poinsot_golden_update_with_all id)
  if(NOT TARGET poinsot_golden_update)
    add_custom_target(poinsot_golden_update)
  endif()
  add_dependencies(poinsot_golden_update poinsot_golden_update_${id})
endfunction()

# Checks the arguments that both functions share, and sets working to the folder in which a test's command runs.
macro(_poinsot_golden_begin function)
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${function}: unknown arguments: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT POINSOT_PROGRAM)
    message(FATAL_ERROR "${function}: the program poinsot is missing; set POINSOT_PROGRAM")
  endif()
  if(NOT ARG_NAME MATCHES "^[A-Za-z0-9_-][A-Za-z0-9_.-]*$")
    message(FATAL_ERROR "${function}: NAME \"${ARG_NAME}\": use only letters, digits, _, - and .")
  endif()
  set(working ${CMAKE_CURRENT_BINARY_DIR})
  if(ARG_WORKING_DIRECTORY)
    get_filename_component(working ${ARG_WORKING_DIRECTORY} ABSOLUTE)
  endif()
endmacro()

# Writes the arguments of poinsot_add_golden_test() as a golden.toml with one test, which has the name of its reference.
function(_poinsot_golden_write_manifest file reference references)
  _poinsot_toml(references "${references}")
  set(text "references = ${references}\n[[test]]\nname = \"${reference}\"\n")
  foreach(key scene image)
    if(${key})
      _poinsot_toml(word "${${key}}")
      string(APPEND text "${key} = ${word}\n")
    endif()
  endforeach()
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
  file(WRITE ${file} "${text}${rule}")
endfunction()

function(poinsot_add_golden_test)
  set(limits MAX PIXELS FLIP_MEAN FLIP_MAX REASON)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "NAME;SCENE;TIME;IMAGE;BASELINE;WORKING_DIRECTORY;${limits}"
    "COMMAND;SIZE;SET;LABELS")
  _poinsot_golden_begin(poinsot_add_golden_test)
  if(NOT ARG_BASELINE MATCHES "[.]png$")
    message(FATAL_ERROR "poinsot_add_golden_test(${ARG_NAME}): expected BASELINE file.png")
  endif()
  if((DEFINED ARG_SCENE AND DEFINED ARG_COMMAND) OR
      NOT (DEFINED ARG_SCENE OR (DEFINED ARG_COMMAND AND DEFINED ARG_IMAGE)))
    message(FATAL_ERROR "poinsot_add_golden_test(${ARG_NAME}): expected SCENE file, or COMMAND words and IMAGE file")
  endif()

  get_filename_component(baseline ${ARG_BASELINE} ABSOLUTE)
  get_filename_component(reference ${baseline} NAME_WLE)
  get_filename_component(references ${baseline} DIRECTORY)
  if(DEFINED ARG_SCENE)
    get_filename_component(scene ${ARG_SCENE} ABSOLUTE)
  else()
    get_filename_component(image ${ARG_IMAGE} ABSOLUTE BASE_DIR ${working})
  endif()
  set(folder ${CMAKE_BINARY_DIR}/golden/${ARG_NAME})
  _poinsot_golden_write_manifest(${folder}/golden.toml ${reference} ${references})
  set(golden ${POINSOT_PROGRAM} golden ${folder}/golden.toml)
  # A golden.toml may not name files outside its folder, so the folders of this project's files become asset roots.
  foreach(file ${baseline} ${scene} ${image})
    get_filename_component(place ${file} DIRECTORY)
    list(APPEND golden --asset-root ${place})
  endforeach()

  if(DEFINED ARG_COMMAND)
    # Removes picture and outcome of an earlier run, so that the test fails if COMMAND no longer writes the picture.
    set(clear ${CMAKE_COMMAND} -E rm -f ${image} ${folder}/outcome.js)
    add_test(NAME ${ARG_NAME}.clear COMMAND ${clear})
    add_test(NAME ${ARG_NAME}.run COMMAND ${ARG_COMMAND} WORKING_DIRECTORY ${working})
    set_tests_properties(${ARG_NAME}.clear PROPERTIES
      FIXTURES_SETUP poinsot_golden_${ARG_NAME}.clear LABELS "${ARG_LABELS}")
    set_tests_properties(${ARG_NAME}.run PROPERTIES FIXTURES_REQUIRED poinsot_golden_${ARG_NAME}.clear
      FIXTURES_SETUP poinsot_golden_${ARG_NAME} LABELS "${ARG_LABELS}")
    set(fixture poinsot_golden_${ARG_NAME})
    set(make COMMAND ${clear} COMMAND ${ARG_COMMAND})
  endif()
  _poinsot_golden_add_test(TEST ${ARG_NAME} COMMAND ${golden} CHOICE --only=${reference} WORKING_DIRECTORY ${working}
    LABELS ${ARG_LABELS} FIXTURES_REQUIRED ${fixture})
  add_custom_target(poinsot_golden_update_${ARG_NAME} ${make} COMMAND ${golden} -o ${folder} --update --only=${reference}
    WORKING_DIRECTORY ${working} VERBATIM USES_TERMINAL)
  _poinsot_golden_update_with_all(${ARG_NAME})
endfunction()

# Sets result to the cases of a golden.toml, as JSON.
function(_poinsot_golden_list result file)
  execute_process(COMMAND ${ARGN} --list --json WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    OUTPUT_VARIABLE json ERROR_VARIABLE problem RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    if(NOT problem)
      set(problem "cannot run ${POINSOT_PROGRAM}: ${code}; set POINSOT_PROGRAM to the program poinsot")
    endif()
    message(FATAL_ERROR "poinsot_add_golden_suite(${file}): ${problem}")
  endif()
  set(${result} "${json}" PARENT_SCOPE)
endfunction()

# Runs CMake again when the set of files that match a pattern of scenes changes.
function(_poinsot_golden_watch folder pattern)
  string(REGEX REPLACE "([[?])" "[\\1]" glob "${folder}/${pattern}")
  set(kind GLOB)
  if(glob MATCHES "/[*][*]/")
    string(REPLACE "/**/" "/" glob "${glob}")
    set(kind GLOB_RECURSE)
  endif()
  file(${kind} ignored CONFIGURE_DEPENDS "${glob}")
endfunction()

function(poinsot_add_golden_suite file)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "NAME;WORKING_DIRECTORY;VARIANT" "LABELS;FIXTURES_REQUIRED")
  get_filename_component(file ${file} ABSOLUTE)
  get_filename_component(place ${file} DIRECTORY)
  if(NOT DEFINED ARG_NAME)
    get_filename_component(ARG_NAME ${file} NAME_WLE)
  endif()
  _poinsot_golden_begin(poinsot_add_golden_suite)
  set(golden ${POINSOT_PROGRAM} golden ${file} --images ${working} --asset-root ${PROJECT_SOURCE_DIR})
  set(update --update)
  if(DEFINED ARG_VARIANT)
    list(APPEND golden --variant ${ARG_VARIANT})
  endif()
  file(STRINGS ${file} variants REGEX "^[ \t]*variant[ \t]*=")
  if(DEFINED ARG_VARIANT OR variants)
    list(APPEND update --beside)  # keeps the references of other variants
  endif()
  _poinsot_golden_list(json ${file} ${golden})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})

  # Removes outcomes of an earlier run, so that the index shows none for tests that ctest does not reach.
  set(cleared poinsot_golden_${ARG_NAME}.clear)
  set(outcomes "")
  set(common COMMAND ${golden} WORKING_DIRECTORY ${working} LABELS ${ARG_LABELS})
  string(JSON count LENGTH "${json}" tests)
  math(EXPR last "${count} - 1")
  set(seen "\n")
  foreach(index RANGE ${last})
    string(JSON only GET "${json}" tests ${index} name)
    string(JSON path ERROR_VARIABLE missing GET "${json}" tests ${index} image)
    set(fixtures ${ARG_FIXTURES_REQUIRED})
    if(missing)
      set(fixtures "")  # fixtures make images; a scene needs none
      string(JSON path GET "${json}" tests ${index} scene)
      if(path MATCHES "[*]")
        _poinsot_golden_watch("${place}" "${path}")
      endif()
    elseif(path MATCHES "[*]")
      set(only "${path}")  # its images may not exist yet
    endif()
    string(FIND "${seen}" "\n${only}\n" at)
    if(at EQUAL -1)
      string(APPEND seen "${only}\n")
      _poinsot_golden_id(id "${ARG_NAME}.${only}")
      list(APPEND outcomes ${CMAKE_BINARY_DIR}/golden/${id}/outcome.js)
      _poinsot_golden_add_test(TEST "${ARG_NAME}.${only}" CHOICE "--only=${only}" ${common}
        FIXTURES_REQUIRED ${cleared} ${fixtures})
      add_custom_target(poinsot_golden_update_${id}
        COMMAND ${golden} -o ${CMAKE_BINARY_DIR}/golden/${id} ${update} "--only=${only}"
        WORKING_DIRECTORY ${working} VERBATIM USES_TERMINAL)
    endif()
  endforeach()

  _poinsot_golden_id(id "${ARG_NAME}.unused")
  list(APPEND outcomes ${CMAKE_BINARY_DIR}/golden/${id}/outcome.js)
  _poinsot_golden_add_test(TEST ${ARG_NAME}.unused CHOICE --unused ${common}
    FIXTURES_REQUIRED ${cleared} ${ARG_FIXTURES_REQUIRED})
  add_test(NAME ${ARG_NAME}.clear COMMAND ${CMAKE_COMMAND} -E rm -f ${outcomes})
  set_tests_properties(${ARG_NAME}.clear PROPERTIES FIXTURES_SETUP ${cleared} LABELS "${ARG_LABELS}")
  add_custom_target(poinsot_golden_update_${ARG_NAME}
    COMMAND ${golden} -o ${CMAKE_BINARY_DIR}/golden/${ARG_NAME} ${update}
    WORKING_DIRECTORY ${working} VERBATIM USES_TERMINAL)
  _poinsot_golden_update_with_all(${ARG_NAME})
endfunction()
