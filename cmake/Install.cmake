# SPDX-License-Identifier: Apache-2.0
# Rules of `cmake --install`. Two components become Debian packages: program for users, and development for other
# projects, with static libraries, public headers, and files for CMake and pkg-config.
include(CMakePackageConfigHelpers)
include(PublicHeaders)

get_property(layers GLOBAL PROPERTY POINSOT_LAYERS)  # highest rank first

if(TARGET poinsot)
  install(TARGETS poinsot RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  # The program looks for its scenes here, relative to its own path (src/cli/scenes_place.cpp).
  install(DIRECTORY scenes/ DESTINATION share/poinsot/scenes COMPONENT program)
  install(DIRECTORY ${POINSOT_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program)
  install(FILES packaging/copyright DESTINATION share/doc/poinsot COMPONENT program)
  install(PROGRAMS packaging/action/compare.sh DESTINATION share/poinsot/ci COMPONENT program)
  install(FILES packaging/action/gitlab.yml DESTINATION share/poinsot/ci COMPONENT program)
endif()
# Not in a package, because Debian packages refer to the system's copy of this licence.
install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/poinsot COMPONENT licence)

# ---- libraries and headers --------------------------------------------------------------------------------------
foreach(layer ${layers})
  set_target_properties(poinsot_${layer} PROPERTIES EXPORT_NAME ${layer})
  list(APPEND libraries poinsot_${layer})
endforeach()
if(TARGET poinsot_glad)
  list(APPEND libraries poinsot_glad)
endif()
install(TARGETS ${libraries} EXPORT poinsotTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
list(JOIN layers "|" any_layer)
list(FILTER POINSOT_PUBLIC_HEADERS INCLUDE REGEX "^(${any_layer})/")
install(CODE "
  set(POINSOT_SOURCES [[${PROJECT_SOURCE_DIR}/src]])
  set(POINSOT_HEADERS [[${POINSOT_PUBLIC_HEADERS}]])
  set(POINSOT_DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${POINSOT_INSTALL_HEADERS}\")
  include([[${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake]])" COMPONENT development)
# Sanitizer suppressions for Mesa, for programs that draw (docs/library.md).
install(FILES tests/support/lsan.supp tests/support/tsan.supp DESTINATION share/poinsot COMPONENT development)

# ---- CMake ------------------------------------------------------------------------------------------------------
install(EXPORT poinsotTargets NAMESPACE poinsot:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/poinsot COMPONENT development)

# poinsot_find_text(RESULT LAYER): sets RESULT to the lines of the config file that find the libraries of one layer.
function(poinsot_find_text result layer)
  get_property(links GLOBAL PROPERTY POINSOT_LINKS_${layer})
  set(text "if(\"${layer}\" IN_LIST _poinsot_wanted)\n")
  foreach(link ${links})
    get_property(find GLOBAL PROPERTY "POINSOT_FIND_${link}")
    if(link MATCHES "^poinsot::(.*)")
      string(APPEND text "  list(APPEND _poinsot_wanted ${CMAKE_MATCH_1})\n")
    elseif(find)
      string(APPEND text "  ${find}\n")
    endif()
  endforeach()
  set(${result} "${text}endif()\n" PARENT_SCOPE)
endfunction()

# Highest rank first, because a layer needs only layers of lower rank.
set(POINSOT_FINDS "")
foreach(layer ${layers})
  poinsot_find_text(text ${layer})
  string(APPEND POINSOT_FINDS "${text}")
endforeach()
set(POINSOT_LAYER_NAMES ${layers})
list(REVERSE POINSOT_LAYER_NAMES)
list(JOIN POINSOT_LAYER_NAMES " " POINSOT_LAYER_NAMES)

# poinsot_config(FOLDER COMPONENT): writes and installs poinsotConfig.cmake. The program and the libraries install a copy
# each. Each copy is complete, and also finds the files of the other component.
set(golden_dir ${CMAKE_INSTALL_DATADIR}/cmake/poinsot)
set(targets_dir ${CMAKE_INSTALL_LIBDIR}/cmake/poinsot)
# SameMinorVersion, because a minor version of 0.x may change the API.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/poinsotConfigVersion.cmake COMPATIBILITY SameMinorVersion)
function(poinsot_config folder component)
  set(file ${PROJECT_BINARY_DIR}/config/${component}/poinsotConfig.cmake)
  configure_package_config_file(packaging/poinsotConfig.cmake.in ${file} INSTALL_DESTINATION ${folder}
    PATH_VARS golden_dir targets_dir NO_CHECK_REQUIRED_COMPONENTS_MACRO)
  install(FILES ${file} ${PROJECT_BINARY_DIR}/poinsotConfigVersion.cmake DESTINATION ${folder} COMPONENT ${component})
endfunction()
poinsot_config(${targets_dir} development)
if(TARGET poinsot)
  poinsot_config(${golden_dir} program)
  install(FILES cmake/PoinsotGolden.cmake cmake/PoinsotGoldenIndex.html.in DESTINATION ${golden_dir} COMPONENT program)
endif()

# ---- pkg-config -------------------------------------------------------------------------------------------------
# poinsot_pc(LAYER): writes and installs poinsot-LAYER.pc. Third parties are in Requires instead of Requires.private:
# our libraries are static but theirs are shared, and `--static` would demand everything that cairo was built from.
function(poinsot_pc layer)
  get_property(links GLOBAL PROPERTY POINSOT_LINKS_${layer})
  set(requires "")
  set(libs "-lpoinsot_${layer}")
  foreach(link ${links})
    get_property(module GLOBAL PROPERTY "POINSOT_REQUIRES_${link}")
    if(link MATCHES "^poinsot::(.*)")
      list(APPEND requires "poinsot-${CMAKE_MATCH_1}")
    elseif(module)
      list(APPEND requires "${module}")
    elseif(NOT link MATCHES "::")  # Threads::Threads has no module, because threads are in the C library
      string(APPEND libs " -l${link}")
    endif()
  endforeach()
  list(JOIN requires ", " requires)
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up ${up})
  configure_file(packaging/layer.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/poinsot-${layer}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/poinsot-${layer}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endfunction()
foreach(layer ${layers})
  poinsot_pc(${layer})
endforeach()
