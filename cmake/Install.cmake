# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts under a prefix. Two components: the program is what a user needs and what the .deb holds;
# development is what other projects need: static libraries, public headers, and how to find them by CMake or pkg-config.
include(CMakePackageConfigHelpers)
include(PublicHeaders)

get_property(layers GLOBAL PROPERTY POINSOT_LAYERS)

install(TARGETS poinsot RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Where the program looks for its scenes, from its own place (src/cli/scenes_place.cpp).
install(DIRECTORY scenes/ DESTINATION share/poinsot/scenes COMPONENT program)
install(DIRECTORY ${POINSOT_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program)
install(FILES packaging/copyright DESTINATION share/doc/poinsot COMPONENT program)
# Not in the .deb: Debian has the text of this licence once for all, and refers to it.
install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/poinsot COMPONENT development)

# ---- libraries and headers --------------------------------------------------------------------------------------
foreach(layer ${layers})
  set_target_properties(poinsot_${layer} PROPERTIES EXPORT_NAME ${layer})
  list(APPEND libraries poinsot_${layer})
endforeach()
install(TARGETS ${libraries} poinsot_glad EXPORT poinsotTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(CODE "
  set(POINSOT_SOURCES [[${CMAKE_SOURCE_DIR}/src]])
  set(POINSOT_HEADERS [[${POINSOT_PUBLIC_HEADERS}]])
  set(POINSOT_DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${POINSOT_INSTALL_HEADERS}\")
  include([[${CMAKE_SOURCE_DIR}/cmake/InstallHeaders.cmake]])" COMPONENT development)

# ---- CMake ------------------------------------------------------------------------------------------------------
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/poinsot)
install(EXPORT poinsotTargets NAMESPACE poinsot:: DESTINATION ${package_dir} COMPONENT development)

# poinsot_find_text(RESULT LAYER): the lines of the config file that find what one layer needs.
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

# From the highest rank down: what a layer wants is below it.
set(POINSOT_FINDS "")
list(REVERSE layers)
foreach(layer ${layers})
  poinsot_find_text(text ${layer})
  string(APPEND POINSOT_FINDS "${text}")
endforeach()
list(REVERSE layers)
list(JOIN layers " " POINSOT_LAYERS)
configure_package_config_file(packaging/poinsotConfig.cmake.in ${CMAKE_BINARY_DIR}/poinsotConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# 0.x: a minor version may change the API.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/poinsotConfigVersion.cmake COMPATIBILITY SameMinorVersion)
# With the program, for golden images; the libraries are another component.
install(FILES ${CMAKE_BINARY_DIR}/poinsotConfig.cmake ${CMAKE_BINARY_DIR}/poinsotConfigVersion.cmake
  cmake/PoinsotGolden.cmake cmake/PoinsotGoldenIndex.html.in DESTINATION ${package_dir} COMPONENT program)

# ---- pkg-config -------------------------------------------------------------------------------------------------
# poinsot_pc(LAYER): writes and installs poinsot-LAYER.pc. Third parties are required in the open, not privately: our
# libraries are static, theirs are not, and `--static` would ask for all that cairo was built from.
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
    else()
      string(APPEND libs " -l${link}")
    endif()
  endforeach()
  list(JOIN requires ", " requires)
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up ${up})
  configure_file(packaging/layer.pc.in ${CMAKE_BINARY_DIR}/pkgconfig/poinsot-${layer}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/pkgconfig/poinsot-${layer}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endfunction()
foreach(layer ${layers})
  poinsot_pc(${layer})
endforeach()
